// Strands drawn by compute shaders of OpenGL 4.5: the same stages as Raster's, and the same picture but for rounding.
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

/// A rasterizer that belongs to the thread of its GL. It submits a box at once: only reading the picture waits for the
/// GPU. It draws the same scene with the same bits each time.
class GpuRaster {
 public:
  /// Builds the stages that draw light; the others are built when they are first needed. The GL outlives this object.
  /// No buffer gets larger than `max_bytes`, nor than the GL allows: what needs more is drawn in bands. Fails with
  /// unavailable if a shader cannot be built.
  static Result<std::unique_ptr<GpuRaster>> create(const Gl& gl, std::size_t max_bytes = ~std::size_t{0});
  ~GpuRaster();

  /// Returns whether these strands of a model can be drawn: both fit into buffers of this GL.
  bool can_draw(const FurModel& model, const GrownFur& fur) const;
  /// Returns how many pixels a box that is drawn at once may have.
  int box_pixels() const;

  /// Draws a box as Raster::draw_box and Raster::darken_box do. Fails with unavailable if a shader cannot be built or
  /// the GL was lost, and with too_large if it runs out of memory: then nothing of the box is in the picture.
  Status draw_box(const RasterScene& scene, const PixelBox& box, FloatImage& picture, RasterCounts& counts);
  /// Draws the whole of a scene's light as an encoded picture of eight bits, of the encoding's size: larger light is
  /// averaged, smaller light is enlarged (ResizedLight). Returns none if it does not fit into one box. Fails as
  /// draw_box does.
  Result<std::optional<Image>> draw_picture(const RasterScene& scene, const Encoding& encoding);

  /// Drops what was sent of all scenes. Call it after any of them is gone.
  void forget();

  /// Adds the milliseconds of each stage to `times` from now on, for measurements; null stops it.
  void measure(std::map<Stage, double>* times);
  /// Returns whether the GL was reset: it draws nothing more.
  bool lost() const { return lost_; }

 private:
  GpuRaster(const Gl& gl, std::size_t max_bytes);
  /// Draws a box on the GPU, up to its rows of pixels, and encodes them if `encoding` is given. Returns false if there
  /// is no room for it.
  Result<bool> draw_rows(const RasterScene& scene, const PixelBox& box, RasterCounts& counts,
                         const Encoding* encoding = nullptr);
  Status draw_halves(const RasterScene& scene, const PixelBox& box, FloatImage& picture, RasterCounts& counts);

  struct Held;
  std::unique_ptr<Held> held_;
  bool lost_ = false;
};

}  // namespace pelage
