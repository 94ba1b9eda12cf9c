#include "renderer/raster/raster_optics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/coat/slices.h"
#include "renderer/coat/strand_tile.h"
#include "renderer/upload/blocks.h"

namespace pelage {

/// Through a height dh, a ray at 45 degrees to upright strands travels sqrt(2) dh, and each strand's width across it is
/// width sin(45). So it crosses the sum of the strands' widths on a unit of ground, times dh.
std::array<float, slice_count> strands_above(const Coat& coat) {
  std::array<double, slice_count + 1> sum{};
  const std::vector<Strand> strands = make_strands(coat);
  for (const Strand& strand : strands) {
    for (int i = slice_count - 1; i >= 0; --i) {
      const double s = (i + 0.5) / slice_count;
      if (strand.length_share < s) continue;
      sum[static_cast<std::size_t>(i)] +=
          strand.width * glm::mix(coat.width_root, coat.width_tip, s / strand.length_share);
    }
  }
  std::array<float, slice_count> above{};
  const double over = nominal_length / slice_count / (coat.tile * coat.tile);
  double total = 0;
  for (std::size_t i = slice_count; i-- > 0;) {
    above[i] = static_cast<float>((total + 0.5 * sum[i]) * over);
    total += sum[i];
  }
  return above;
}

FrameOptics RasterOptics::of(const FurFrame& frame, const FurModel& model) {
  if (!coat_ || !same_strands(*coat_, frame.coat())) coat_ = frame.coat(), above_ = strands_above(frame.coat());
  const Look look = wet_look(frame.wetness(), frame.look);
  if (look_ != look) {
    look_ = look;
    scattering_ = scattering_block(look), azimuthal_ = fit_azimuthal(make_scattering_table(look));
  }
  FrameOptics optics;
  optics.frame =
      make_frame_block(frame, Slices{std::vector<SliceLevel>(slice_levels), above_}, model.has_colours, frame.height);
  optics.scattering = scattering_, optics.azimuthal = &azimuthal_;
  optics.model = static_cast<int>(frame.look.shading), optics.lights = static_cast<int>(frame.lights.size());
  optics.directional_lights = std::all_of(frame.lights.begin(), frame.lights.end(),
                                          [](const FurLight& light) { return light.kind == LightKind::directional; });
  optics.model_colours = optics.frame.skin.w > 0.5f;
  if (!frame.skin.empty()) optics.skin = make_skin_block(frame.skin);
  if (!frame.eyes.empty() && !eyes_) eyes_.emplace();
  if (!frame.eyes.empty()) optics.eyes = eyes_->of(frame);
  if (optics.model_colours && !model.images.empty()) {
    if (!images_ || pictured_ != model.id) images_.emplace(model.images), pictured_ = model.id;
    optics.images = &*images_;
  }
  optics.wetness = static_cast<float>(frame.wetness());
  return optics;
}

LightSize size_of(const FurLight& light) {
  constexpr float widest_light = 1.4f;  // radians
  switch (light.kind) {
    case LightKind::directional: return {std::tan(std::min(light.angle, widest_light)), true};
    case LightKind::area: return {std::sqrt(light.extent.x * light.extent.y / std::numbers::pi_v<float>), false};
    default: return {light.radius, false};
  }
}

PictureCamera picture_camera(const FurFrame& frame) {
  const FurCamera& camera = frame.camera;
  const float half = 0.5f * static_cast<float>(frame.height);
  return {camera.position,
          camera.right,
          camera.up,
          camera.forward,
          half / camera.tan_half_fov,
          {0.5f * static_cast<float>(frame.width), half}};
}

}  // namespace pelage
