// Strands drawn by compute shaders of OpenGL 4.5: the same stages as Raster's, and the same picture but for rounding.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "protocol/base/status.h"
#include "renderer/finish/encode.h"
#include "renderer/gl/functions.h"
#include "renderer/image/float_image.h"
#include "renderer/image/image.h"
#include "renderer/raster/raster.h"

namespace pelage {

enum class Stage;

/// Belongs to the thread of its GL. A box is one submission: nothing waits for the GPU but who reads the picture. Of
/// the same scene it draws the same bits.
class GpuRaster {
 public:
  /// Builds what light is drawn by; the rest when it is first asked for. The GL outlives it. No buffer gets larger than
  /// `max_bytes`, nor than the GL allows: what needs more is drawn in bands. Fails with unavailable where a shader
  /// cannot be built.
  static Result<std::unique_ptr<GpuRaster>> create(const Gl& gl, std::size_t max_bytes = ~std::size_t{0});
  ~GpuRaster();

  /// Whether these strands of a model can be drawn: both fit into buffers of this GL.
  bool can_draw(const FurModel& model, const GrownFur& fur) const;
  /// Of a box that it draws at once.
  int box_pixels() const;

  /// As Raster::draw_box and Raster::darken_box. Fails with unavailable where a shader cannot be built, or where the GL
  /// was lost, and with too_large where it has no memory: nothing of the box is in the picture then.
  Status draw_box(const RasterScene& scene, const PixelBox& box, FloatImage& picture, RasterCounts& counts);
  /// The whole of a scene's light as a picture of eight bits that is encoded so, of its size; of light that is larger
  /// the means, of smaller enlarged (ResizedLight). None where it does not fit into one box. Fails as draw_box.
  Result<std::optional<Image>> draw_picture(const RasterScene& scene, const Encoding& encoding);

  /// Drops what was sent of scenes: after any of them has gone.
  void forget();

  /// Adds the milliseconds of each stage to `times` from here on, for who measures; null for no more.
  void measure(std::map<Stage, double>* times);
  /// Whether the GL was reset: it draws nothing more.
  bool lost() const { return lost_; }

 private:
  GpuRaster(const Gl& gl, std::size_t max_bytes);
  /// Draws a box as far as rows of pixels on the GPU, and encodes them where that is given; false where there is no
  /// room for it.
  Result<bool> draw_rows(const RasterScene& scene, const PixelBox& box, RasterCounts& counts,
                         const Encoding* encoding = nullptr);
  Status draw_halves(const RasterScene& scene, const PixelBox& box, FloatImage& picture, RasterCounts& counts);

  struct Held;
  std::unique_ptr<Held> held_;
  bool lost_ = false;
};

}  // namespace pelage
