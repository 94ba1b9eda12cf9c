// Draws frames of rasterized strands. Grown fur is cached for each model, and so are the last views, so that after a
// stroke only the parts that it changed grow, and only the part of the picture that it may change is drawn.
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

// Long drawings can be interrupted.

/// Called between two boxes of a drawing. It may draw other frames with the same renderer. Returns false to give the
/// drawing up; if it returns true, the drawing's model has to be as it was before.
using Pause = std::function<bool()>;

inline Status drawing_given_up() { return failure(Code::conflict, "the drawing was given up"); }
inline Status no_memory_for_frame() { return failure(Code::too_large, "no memory for a frame of this size", "/width"); }

struct Gl;
class GpuRaster;
class RasterScratch;
struct RasterFur;
struct RasterModel;
enum class RasterOutput;
struct RasterScene;
struct SkinLook;
struct PixelBox;
class TileMask;

/// Belongs to one thread; draws on up to `threads` threads, with the same bits for any number.
class RasterRenderer {
 public:
  explicit RasterRenderer(int threads);
  ~RasterRenderer();
  /// From here on draws by compute shaders of a GL, which must outlive their use. The CPU draws if `gl` is null or
  /// cannot build the shaders, and frames whose strands do not fit into the GL's memory.
  void take_gl(const Gl* gl);
  bool has_gl() const { return gpu_ != nullptr; }
  /// Returns whether the GL that draws strands was reset.
  bool lost_gl() const;

  bool has(std::uint64_t model) const { return models_.contains(model); }
  /// Both return the number of bytes that were copied.
  std::size_t add(const FurModel& model, EachCoat<FurFields> fields);
  std::size_t update(std::uint64_t model, EachCoat<FurFields> fields);
  void forget(std::uint64_t original);
  void forget_all();
  /// Returns the bytes of all copies of a model (FurModel::original) with their strands, without those on a GPU.
  std::size_t bytes_of(std::uint64_t original) const;

  /// Grows what the frame shows and has changed; otherwise, drawing the frame does that first.
  void grow(const FurFrame& frame);

  // As in Renderer, but pictures always have the frame's size: with a crop, what lies outside it is not drawn.
  // `overlay` has the frame's size, null for none. The pause is called between boxes, of about a million pixels on the
  // CPU and 16 million on a GPU.
  Result<Image> draw(const FurFrame& frame, const FloatImage* overlay, DrawTimes& times, const Pause& pause);
  Result<Image16> draw_deep(const FurFrame& frame, const FloatImage* overlay, DrawTimes& times, const Pause& pause);
  Result<std::vector<FloatImage>> draw_aovs(const FurFrame& frame, std::span<const Aov> aovs, DrawTimes& times,
                                            const Pause& pause);
  /// Draws FurFrame::overlay, which has to be a field, on the fur itself: at the frame's size, sRGB with straight
  /// alpha.
  Result<FloatImage> field_overlay(const FurFrame& frame, DrawTimes& times, const Pause& pause);
  /// The same for an overlay that shows the shape of the model.
  Result<FloatImage> shape_overlay(const FurFrame& frame, DrawTimes& times);
  Result<Backplate> draw_backplate(const FurFrame& frame, DrawTimes& times);
  void clear_view_cache() { views_.invalidate(); }

 private:
  /// Which strands of a coat grow: all, for outputs that number them, or no more than the frame keeps.
  enum class Growth { all, only_drawn };
  /// What is drawn of a frame, and how.
  struct Wanted {
    RasterOutput shown;
    std::span<const glm::vec3> field = {};  // for each vertex; RasterOutput::field alone
    const TileMask* tiles = nullptr;        // tiles to draw; null for all
    Growth growth = Growth::only_drawn;
    bool by_gpu = false;
    std::size_t first_object = 0;  // RasterScene::first_object
  };
  /// Returns the fur of the frame's model from which it is drawn: all strands, or the thin share.
  RasterFur& fur_for(const FurFrame& frame, Growth growth);
  /// Grows what has changed, as `wanted` asks. Evicts what is cached of other models if it takes too much memory, least
  /// recently used first.
  RasterFur& grown(const FurFrame& frame, const Wanted& wanted);
  void evict_others(const RasterModel& own);
  RasterScene scene_of(RasterFur& raster_fur, const FurFrame& frame, const Wanted& wanted) const;
  /// Draws an area of a frame into a picture; the frame has the size of its light. With wanted.by_gpu the GPU draws,
  /// and darkens the ground; if it fails, the CPU draws, without the ground, and by_gpu becomes false. Fails with
  /// conflict if the pause gives up, and with unavailable if the GL was lost.
  Status draw_area(const FurFrame& frame, const Area& area, Wanted& wanted, DrawTimes& times, const Pause& pause,
                   FloatImage& picture);
  Status draw_boxes(const FurFrame& frame, std::span<const PixelBox> boxes, const Wanted& wanted, DrawTimes& times,
                    const Pause& pause, FloatImage& picture);
  /// Returns whether the CPU can make up for a failure of the GPU. A GPU that cannot build a shader draws nothing more.
  bool cpu_takes_over(const Status& failed);
  /// Grows a frame's strands. Returns whether the GPU can draw them.
  bool draws_on_gpu(const FurFrame& frame, Growth growth, DrawTimes& times);
  /// Draws a whole picture without an overlay and finishes it on the GPU. Returns none if draws_on_gpu is false or
  /// memory is short.
  Result<std::optional<Image>> draw_on_gpu(const FurFrame& frame, DrawTimes& times);
  /// Darkens the visible ground, if the frame has one and light is shown.
  void darken(const FurFrame& frame, RasterFur& raster_fur, const Wanted& wanted, FloatImage& picture) const;
  Result<FloatImage> draw_full_frame(const FurFrame& frame, Wanted wanted, DrawTimes& times, const Pause& pause);
  /// Draws the skin and the eyes alone, in unshadowed light.
  FloatImage draw_bare(RasterModel& model, const FurFrame& frame, std::span<const std::array<SkinLook, 3>> skin,
                       RasterOutput shown) const;
  /// Returns the tiles whose light may have changed since a view was shown.
  TileMask changed_tiles(const FurFrame& frame, const ShownFrame& shown);
  /// Draws a frame's light, reusing what is cached of its view, and returns finish(view, light, area that was drawn).
  template <class Picture, class Finish>
  Result<Picture> draw_finished(const FurFrame& frame, int format, DrawTimes& times, const Pause& pause,
                                const Finish& finish);

  int threads_;
  std::unique_ptr<GpuRaster> gpu_;  // null: the CPU draws
  std::shared_ptr<RasterScratch> scratch_;
  std::map<std::uint64_t, std::unique_ptr<RasterModel>> models_;
  std::uint64_t uses_ = 0;
  ViewCache views_;
};

}  // namespace pelage
