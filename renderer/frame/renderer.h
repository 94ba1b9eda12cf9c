// Frames, whoever draws them: the one door in front of rasterized strands and of shells.
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
  std::size_t sorted_bytes = SortedPass::default_bytes;  // fragments that a sorted frame keeps at a time (SortedPass)
  int threads = default_threads();                       // of what is drawn on the CPU
  CoatSource coats = bake_here;                          // where slices come from, for shells
  bool software_gl_draws_strands = false;                // slower than the CPU does: for tests
};

/// Rasterizes strands on a GPU where its GL has one, else on the CPU; draws shells by a GL where it has one. Of a frame
/// with a crop all pictures have the crop's size, and the bits that the whole frame has there; light that is to be
/// finished, and backplates, are of the whole. Belongs to the thread and the context that it was made on.
class Renderer {
 public:
  /// With a GL, which outlives it. Fails (unavailable) when a program cannot be built.
  static Result<std::unique_ptr<Renderer>> create(const Gl& gl, const RendererOptions& options = {});
  /// Without shells.
  explicit Renderer(const RendererOptions& options) : options_(options), raster_(options.threads) {}
  /// Draws by another GL from here on, by none where it is null; what the one before was sent is gone. Fails as
  /// create, and then has none.
  Status take_gl(const Gl* gl);
  /// Returns whether its GL was reset or does not answer: it draws nothing more.
  bool lost_gl() const { return (shells_ && shells_->lost()) || raster_.lost_gl(); }

  /// Returns whether its GL rasterizes strands.
  bool strands_by_gl() const { return raster_.has_gl(); }

  bool has(std::uint64_t model) const { return raster_.has(model); }
  /// Takes a model that the renderer does not have yet, with its fields.
  UploadCount add(const FurModel& model, EachCoat<FurFields> fields);
  /// Returns whether a frame can be drawn: not shells without a GL (invalid, with a pointer into the request).
  Status can_draw(const FurFrame& frame) const;
  /// Returns whether it has what shells of a model need, and taking that, where there is a GL.
  bool has_shells(std::uint64_t model) const { return shells_ && shells_->has(model); }
  UploadCount add_shells(const FurModel& model, EachCoat<FurFields> fields);
  /// Takes over the dirty ranges of a model that it has.
  UploadCount update(std::uint64_t model, EachCoat<FurFields> fields);

  /// Grows the strands of a frame that have changed: what drawing it would do first.
  void grow(const FurFrame& frame);

  /// Draws a model that it has, and as can_draw says; after changes of its fields alone only the part of the picture
  /// that they may touch, with the same bits. With `pause` a long drawing of strands is done in boxes, with the same
  /// bits, and the pause is called in between; its time does not count. Fails with conflict when the pause gives the
  /// drawing up, with too_large when there is no memory for the size, and as ShellsRenderer::draw does.
  Result<Image> draw(const FurFrame& frame, DrawTimes* times = nullptr, const Pause& pause = {});
  /// The same picture with 16 bits.
  Result<Image16> draw_deep(const FurFrame& frame, DrawTimes* times = nullptr, const Pause& pause = {});
  /// Light and what is asked for beside it, one picture for each AOV, in internal coordinates: without exposure, tone
  /// map, background and overlay. Colours have alpha in the fourth number; position, normal, tangent and shadow (in the
  /// first three) the coverage. The first number of depth is one over the distance along the view, 0 for none.
  Result<std::vector<FloatImage>> draw_aovs(const FurFrame& frame, std::span<const Aov> aovs,
                                            DrawTimes* times = nullptr, const Pause& pause = {});

  /// Draws what traced strands stand on: skin, bare skin and eyes in the light of all lights, without fur, shadows,
  /// ground and curves. Of the knobs only eye_steps counts. The result has twice the frame's size if that is at most
  /// 2048 a side, else the frame's size. The skin under fur has the colour of the roots. Fails with too_large if there
  /// is no memory for it.
  Result<Backplate> draw_backplate(const FurFrame& frame, DrawTimes* times = nullptr);
  /// A traced picture of the frame's size, as `draw` shows what it has drawn: exposure, tone map, background and
  /// overlay. `light` is premultiplied linear light.
  Result<Image> finish(const FurFrame& frame, const FloatImage& light, DrawTimes* times = nullptr);
  Result<Image16> finish_deep(const FurFrame& frame, const FloatImage& light, DrawTimes* times = nullptr);

  /// Makes the next frame be drawn whole, for who measures or doubts.
  void clear_view_cache() { raster_.clear_view_cache(); }
  /// Returns whether the frame reads slices that the renderer does not have yet: it gets them from its source once it
  /// draws.
  bool misses_coat(const FurFrame& frame) const;
  /// What all copies of a model (FurModel::original) take in memory, with their GL objects.
  std::size_t bytes_of(std::uint64_t original) const;
  /// Storage of all GL objects: models, coats, targets, maps.
  std::size_t gl_bytes() const { return shells_ ? shells_->gl_bytes() : 0; }
  /// Drops all copies of a model (FurModel::original).
  void forget(std::uint64_t original);
  /// Drops the copies of all models, and the pictures kept of them.
  void forget_all();

 private:
  /// What lies over strands, rasterized or traced: fields on the fur, or the shape of the model; empty for nothing.
  Result<FloatImage> overlay_of(const FurFrame& frame, DrawTimes& times, const Pause& pause);
  /// draw(overlay, times) with that; null for nothing.
  template <class Picture, class Draw>
  Result<Picture> with_overlay(const FurFrame& frame, DrawTimes* times, const Pause& pause, const Draw& draw);
  Result<FloatImage> draw_shells(const FurFrame& frame, DrawTimes& times);

  RendererOptions options_;
  RasterRenderer raster_;
  std::unique_ptr<ShellsRenderer> shells_;  // null: there is no GL
};

}  // namespace pelage
