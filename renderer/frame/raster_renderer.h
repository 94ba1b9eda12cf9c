// Frames of rasterized strands. What a coat grows is kept for each model, and the last views are, so that a stroke
// grows its part alone and draws the part of a picture that it may change.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/status.h"
#include "renderer/frame/draw_clock.h"
#include "renderer/frame/view_cache.h"
#include "renderer/image/float_image.h"
#include "renderer/input/fur_scene.h"
#include "renderer/strands/tracer.h"

namespace pelage {

// Long drawings let others in.

/// Asked between two boxes of a drawing. It may draw other frames with the same renderer meanwhile; false gives the
/// drawing up. The drawing's model has to be as it was when it answers true.
using Pause = std::function<bool()>;

inline Status drawing_given_up() { return failure(Code::conflict, "the drawing was given up"); }
inline Status no_memory_for_frame() { return failure(Code::too_large, "no memory for a frame of this size", "/width"); }

struct Gl;
class GpuRaster;
class RasterRoom;
struct RasterFur;
struct RasterModel;
enum class RasterOutput;
struct RasterScene;
struct SkinLook;
struct PixelBox;
class TileMask;

/// Belongs to one thread; draws on up to `threads`, with the same bits for any number of them.
class RasterRenderer {
 public:
  explicit RasterRenderer(int threads);
  ~RasterRenderer();
  /// Draws by compute shaders of a GL from here on, which outlives that; by the CPU where it is null, cannot build
  /// them, or has no room for a frame's strands.
  void take_gl(const Gl* gl);
  bool has_gl() const { return gpu_ != nullptr; }
  /// Returns whether the GL that draws was reset.
  bool lost_gl() const;

  bool has(std::uint64_t model) const { return models_.contains(model); }
  /// Both give the bytes that were taken over.
  std::size_t add(const FurModel& model, EachCoat<FurFields> fields);
  std::size_t update(std::uint64_t model, EachCoat<FurFields> fields);
  void forget(std::uint64_t original);
  void forget_all();
  /// Of all copies of a model (FurModel::original), with their strands; not what a GPU has of them.
  std::size_t bytes_of(std::uint64_t original) const;

  /// Grows what the frame shows and has changed, which drawing it else does first.
  void grow(const FurFrame& frame);

  // As Renderer has them, but that with a crop what lies outside it is not drawn; `overlay` is of the frame's size,
  // null for none. The pause is called between boxes: of about a million pixels on the CPU, of 16 on a GPU.
  Result<Image> draw(const FurFrame& frame, const FloatImage* overlay, DrawTimes& times, const Pause& pause);
  Result<Image16> draw_deep(const FurFrame& frame, const FloatImage* overlay, DrawTimes& times, const Pause& pause);
  Result<std::vector<FloatImage>> draw_aovs(const FurFrame& frame, std::span<const Aov> aovs, DrawTimes& times,
                                            const Pause& pause);
  /// FurFrame::overlay, which is a field, on the fur itself, at the frame's size: sRGB with straight alpha.
  Result<FloatImage> field_overlay(const FurFrame& frame, DrawTimes& times, const Pause& pause);
  /// The same of what is the shape of the model.
  Result<FloatImage> shape_overlay(const FurFrame& frame, DrawTimes& times);
  Result<Backplate> draw_backplate(const FurFrame& frame, DrawTimes& times);
  void clear_view_cache() { views_.clear_shown(); }

 private:
  /// Which strands of a coat grow: all where they are numbered, else no more than the frame keeps.
  enum class Growth { all, as_kept };
  /// What of a frame is drawn.
  struct Wanted {
    RasterOutput shown;
    std::span<const glm::vec3> field = {};  // of each vertex, where that is shown
    const TileMask* tiles = nullptr;        // null for all
    Growth growth = Growth::as_kept;
    bool by_gpu = false;
    std::size_t first_object = 0;  // of those that are shown
  };
  RasterFur& standing_for(const FurFrame& frame, Growth growth);
  /// Grows what has changed, as `wanted` asks. Drops what is cached of other models if all of it takes too much memory,
  /// the longest unused first.
  RasterFur& grown(const FurFrame& frame, const Wanted& wanted);
  void keep_within_bounds(const RasterModel& own);
  RasterScene scene_of(RasterFur& standing, const FurFrame& frame, const Wanted& wanted) const;
  /// Draws an area of a frame that has the size of its light into a picture: by the GPU, with its ground, where it is
  /// wanted and can, which `wanted` says afterwards. Fails with conflict when it is given up, and with unavailable when
  /// the GL was lost.
  Status draw_area(const FurFrame& frame, const Area& area, Wanted& wanted, DrawTimes& times, const Pause& pause,
                   FloatImage& picture);
  Status draw_boxes(const FurFrame& frame, std::span<const PixelBox> boxes, const Wanted& wanted, DrawTimes& times,
                    const Pause& pause, FloatImage& picture);
  /// Returns whether the CPU can make up for a failure of the GPU. A GPU that cannot build a shader draws nothing more.
  bool cpu_goes_on(const Status& failed);
  /// Returns whether the GPU draws a frame's strands, which are grown first.
  bool draws_on_gpu(const FurFrame& frame, Growth growth, DrawTimes& times);
  /// Draws a whole picture without an overlay and finishes it on the GPU; empty if draws_on_gpu is false or memory is
  /// short.
  Result<std::optional<Image>> draw_on_gpu(const FurFrame& frame, DrawTimes& times);
  /// What the ground is seen of, where there is one.
  void darken(const FurFrame& frame, RasterFur& standing, const Wanted& wanted, FloatImage& picture) const;
  Result<FloatImage> draw_whole(const FurFrame& frame, Wanted wanted, DrawTimes& times, const Pause& pause);
  /// The skin and the eyes alone, in light that nothing stands in the way of.
  FloatImage draw_bare(RasterModel& model, const FurFrame& frame, std::span<const std::array<SkinLook, 3>> skin,
                       RasterOutput shown) const;
  /// What of a view's light is not as it was when it was shown.
  TileMask changed_tiles(const FurFrame& frame, const ShownFrame& shown);
  /// finish(view, light, area that was drawn).
  template <class Picture, class Finish>
  Result<Picture> draw_finished(const FurFrame& frame, int format, DrawTimes& times, const Pause& pause,
                                const Finish& finish);

  int threads_;
  std::unique_ptr<GpuRaster> gpu_;  // null: the CPU draws
  std::shared_ptr<RasterRoom> room_;
  std::map<std::uint64_t, std::unique_ptr<RasterModel>> models_;
  std::uint64_t uses_ = 0;
  ViewCache views_;
};

}  // namespace pelage
