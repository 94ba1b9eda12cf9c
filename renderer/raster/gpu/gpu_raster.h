// The rasterizer of strands on a GPU, by compute shaders of OpenGL 4.5: the stages of Raster, and the same picture up
// to rounding.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "base/status.h"
#include "renderer/finish/encode.h"
#include "renderer/gl/functions.h"
#include "renderer/image/float_image.h"
#include "renderer/image/image.h"
#include "renderer/raster/raster.h"

namespace pelage {

enum class Stage;

/// Belongs to the thread of its GL. All stages of a box are submitted before it waits for the GPU. The same scene has
/// the same bits each time.
class GpuRaster {
 public:
  /// Builds the stages that draw light; the others are built when they are first needed. The GL outlives this object.
  /// No buffer gets larger than `max_bytes`, nor than the GL allows: what needs more is drawn in bands. Fails with
  /// unavailable if a shader cannot be built.
  static Result<std::unique_ptr<GpuRaster>> create(const Gl& gl, std::size_t max_bytes = ~std::size_t{0});
  ~GpuRaster();

  /// Returns whether a model with these strands can be drawn: both fit into buffers of this GL.
  bool can_draw(const FurModel& model, const GrownFur& fur) const;
  /// Returns the largest number of pixels that a box drawn at once may have.
  int box_pixels() const;

  /// Draws a box as Raster::draw_box and Raster::darken_box do. Fails with unavailable if a shader cannot be built or
  /// the GL was lost, and with too_large if it runs out of memory: then nothing of the box is in the picture.
  Status draw_box(const RasterScene& scene, const PixelBox& box, FloatImage& picture, RasterCounts& counts);
  /// Draws the whole of a scene's light as an encoded picture of eight bits, of the encoding's size: larger light is
  /// averaged, smaller light is enlarged (ResizedLight). Returns none if it does not fit into one box. Fails as
  /// draw_box does.
  Result<std::optional<Image>> draw_picture(const RasterScene& scene, const Encoding& encoding);

  /// Frees what was sent of all scenes. Call it whenever the fur of one is destroyed.
  void forget();

  /// From now on adds the milliseconds of each stage to `times`, for benchmarks. Null turns that off.
  void measure(std::map<Stage, double>* times);
  /// Returns whether the GL was reset; nothing more can be drawn then.
  bool lost() const { return lost_; }

 private:
  GpuRaster(const Gl& gl, std::size_t max_bytes);
  /// Draws a box on the GPU up to its rows of pixels, and encodes them if `encoding` is given. Returns false if its
  /// buffers would get too large.
  Result<bool> draw_rows(const RasterScene& scene, const PixelBox& box, RasterCounts& counts,
                         const Encoding* encoding = nullptr);
  /// Draws the upper and the lower half of a box one after the other, if the whole does not fit into memory.
  Status draw_halves(const RasterScene& scene, const PixelBox& box, FloatImage& picture, RasterCounts& counts);

  struct State;
  std::unique_ptr<State> state_;
  bool lost_ = false;
};

}  // namespace pelage
