// The interface to all renderers: rasterized strands on a GPU or the CPU, and shells on a GL.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "base/status.h"
#include "renderer/frame/raster_renderer.h"
#include "renderer/shells/shells_renderer.h"

namespace pelage {

struct RendererOptions {
  std::size_t sorted_bytes = SortedPass::default_bytes;  // memory for the fragments of a sorted frame (SortedPass)
  int threads = default_threads();                       // for drawing on the CPU
  CoatSource coats = bake_here;                          // source of the baked slices, for shells
  bool software_gl_draws_strands = false;                // slower than drawing on the CPU; for tests
};

/// Rasterizes strands on a GPU if its GL has one, else on the CPU; draws shells if it has a GL. With a crop, pictures
/// have the crop's size and the same bits as the whole frame there; backplates, and light given to finish(), are of the
/// whole frame. Belongs to the thread and the context on which it was made.
class Renderer {
 public:
  /// Makes a renderer with a GL, which must outlive it. Fails with unavailable if a program cannot be built.
  static Result<std::unique_ptr<Renderer>> create(const Gl& gl, const RendererOptions& options = {});
  /// Makes a renderer without a GL, and so without shells.
  explicit Renderer(const RendererOptions& options) : options_(options), raster_(options.threads) {}
  /// From here on draws by another GL, or by none if it is null; what was sent to the previous one is dropped. Fails as
  /// `create` does, and then has no GL for shells.
  Status take_gl(const Gl* gl);
  /// Returns whether its GL was reset or does not answer; it can draw nothing more then.
  bool lost_gl() const { return (shells_ && shells_->lost()) || raster_.lost_gl(); }

  /// Returns whether its GL rasterizes strands.
  bool strands_by_gl() const { return raster_.has_gl(); }

  bool has(std::uint64_t model) const { return raster_.has(model); }
  /// Takes a model that the renderer does not have yet, with its fields.
  UploadCount add(const FurModel& model, EachCoat<FurFields> fields);
  /// Fails with invalid, with a pointer into the request, if a frame cannot be drawn: shells without a GL, or of
  /// several coats.
  Status can_draw(const FurFrame& frame) const;
  /// Returns whether it has what shells of a model need.
  bool has_shells(std::uint64_t model) const { return shells_ && shells_->has(model); }
  /// Takes what shells of a model need, if there is a GL.
  UploadCount add_shells(const FurModel& model, EachCoat<FurFields> fields);
  /// Copies the dirty ranges of a model that it has.
  UploadCount update(std::uint64_t model, EachCoat<FurFields> fields);

  /// Grows the strands of a frame that have changed; otherwise, drawing the frame does that first.
  void grow(const FurFrame& frame);

  /// Draws a frame; can_draw must allow it, and the model be there. If only the model's fields have changed since the
  /// last drawing, it may draw only the part of the picture that they can affect; the bits are the same. `pause` is
  /// called between the boxes of a long drawing of strands; its time does not count. Fails with conflict if the pause
  /// gives the drawing up, with too_large if there is no memory for the size, and as ShellsRenderer::draw does.
  Result<Image> draw(const FurFrame& frame, DrawTimes* times = nullptr, const Pause& pause = {});
  /// The same picture with 16 bits.
  Result<Image16> draw_deep(const FurFrame& frame, DrawTimes* times = nullptr, const Pause& pause = {});
  /// Draws one picture for each AOV, in internal coordinates, without exposure, tone map, background and overlay. The
  /// fourth number is alpha for colours, and coverage for position, normal, tangent and shadow (whose value is in each
  /// of the first three). The first number of depth is 1 / distance along the view, 0 for none.
  Result<std::vector<FloatImage>> draw_aovs(const FurFrame& frame, std::span<const Aov> aovs,
                                            DrawTimes* times = nullptr, const Pause& pause = {});

  /// Draws the backplate of traced strands: skin, bare skin and eyes in the light of all lights, without fur, shadows,
  /// ground and curves. Of the knobs only eye_steps counts. The result has twice the frame's size if that is at most
  /// 2048 a side, else the frame's size. The skin under fur has the colour of the roots. Fails with too_large if there
  /// is no memory for it.
  Result<Backplate> draw_backplate(const FurFrame& frame, DrawTimes* times = nullptr);
  /// Finishes a traced picture as `draw` does its own: exposure, tone map, background and overlay. `light` is
  /// premultiplied linear light of the frame's size.
  Result<Image> finish(const FurFrame& frame, const FloatImage& light, DrawTimes* times = nullptr);
  Result<Image16> finish_deep(const FurFrame& frame, const FloatImage& light, DrawTimes* times = nullptr);

  /// Makes the next frame be drawn as a whole; for benchmarks and tests.
  void clear_view_cache() { raster_.clear_view_cache(); }
  /// Returns whether the frame reads slices that the renderer does not have yet; drawing it then takes them from their
  /// source.
  bool misses_coat(const FurFrame& frame) const;
  /// Returns the bytes of all copies of a model (FurModel::original), with their GL objects.
  std::size_t bytes_of(std::uint64_t original) const;
  /// Returns the bytes of all GL objects: models, coats, targets, maps.
  std::size_t gl_bytes() const { return shells_ ? shells_->gl_bytes() : 0; }
  /// Drops all copies of a model (FurModel::original).
  void forget(std::uint64_t original);
  /// Drops the copies of all models, and their cached views.
  void forget_all();

 private:
  /// Draws the overlay of rasterized or traced strands: a field on the fur, or the shape of the model. Empty for none.
  Result<FloatImage> overlay_of(const FurFrame& frame, DrawTimes& times, const Pause& pause);
  /// Returns the crop of draw(overlay, times) with that overlay, null for none.
  template <class Picture, class Draw>
  Result<Picture> with_overlay(const FurFrame& frame, DrawTimes* times, const Pause& pause, const Draw& draw);
  Result<FloatImage> draw_shells(const FurFrame& frame, DrawTimes& times);

  RendererOptions options_;
  RasterRenderer raster_;
  std::unique_ptr<ShellsRenderer> shells_;  // null without a GL
};

}  // namespace pelage
