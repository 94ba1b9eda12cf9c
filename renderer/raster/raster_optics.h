// Makes the optics of a frame: its camera, its lights' sizes, and the tables that shade its strands, skin and eyes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "renderer/optics/eye_cache.h"
#include "renderer/raster/raster_scene.h"

namespace pelage {

/// Returns for each slice the mean number of strands that a ray at 45 degrees crosses above the slice's middle, in fur
/// nominal_length long: Slices::depth_above, computed from the strands themselves.
std::array<float, slice_count> strands_above(const Coat& coat);

/// Caches the tables of the last look, coat and model.
class RasterOptics {
 public:
  /// Returns the optics of a frame, with views into this object; valid until the next call.
  FrameOptics of(const FurFrame& frame, const FurModel& model);

 private:
  std::optional<Coat> coat_;
  std::array<float, slice_count> above_{};
  std::optional<Look> look_;
  ScatteringBlock scattering_{};
  std::optional<EyeCache> eyes_;  // none before the first eye
  AzimuthalFit azimuthal_;
  std::uint64_t pictured_ = 0;  // id of the model that images_ was made of
  std::optional<BaseImages> images_;
};

PictureCamera picture_camera(const FurFrame& frame);
LightSize size_of(const FurLight& light);

}  // namespace pelage
