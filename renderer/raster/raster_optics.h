// What strands are lit by, made of a frame.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "renderer/optics/eye_cache.h"
#include "renderer/raster/raster_scene.h"

namespace pelage {

/// Strands above the middle of each slice that a ray at 45 degrees crosses on average, in fur nominal_length long
/// (Slices::depth_above, from the strands themselves).
std::array<float, slice_count> strands_above(const Coat& coat);

/// Made once for a look, a coat or a model.
class RasterOptics {
 public:
  /// Views into this object, until the next call.
  FrameOptics of(const FurFrame& frame, const FurModel& model);

 private:
  std::optional<Coat> coat_;
  std::array<float, slice_count> above_{};
  std::optional<Look> look_;
  ScatteringBlock scattering_{};
  std::optional<EyeCache> eyes_;  // none before the first eye
  AzimuthalFit azimuthal_;
  std::uint64_t pictured_ = 0;  // the model of the pictures
  std::optional<BaseImages> images_;
};

PictureCamera picture_camera(const FurFrame& frame);
LightSize size_of(const FurLight& light);

}  // namespace pelage
