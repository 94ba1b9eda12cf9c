// The light on a fibre after GPU fur eq 1 to 3 and science.md 4, in double, as a reference for the shader.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/coat/slices.h"
#include "renderer/light/environment.h"
#include "renderer/upload/blocks.h"
#include "tests/double_shading/fibre_shading.h"

namespace pelage::testing {

/// The inputs of a fibre, as in lighting.glsl.
struct Case {
  glm::vec3 position, normal, tangent, to_camera, colour;
  float height, above, strand;
};

/// Share of the light that a strand of that colour takes: 1 - t^(1 - f_c), f_c = .82 sqrt(C), t = exp(-2 w p).
inline glm::dvec3 stopped(const Look& look, const glm::dvec3& colour, double part = 1) {
  glm::dvec3 share;
  for (int k = 0; k < 3; ++k)
    share[k] = 1 - std::exp(-2 * look.self_shadow * part * (1 - 0.82 * std::sqrt(std::clamp(colour[k], 0.0, 1.0))));
  return share;
}

/// Transmittance of randomly placed strands, N on average: the sum over n of e^-N N^n / n! (1 - stopped)^n.
inline glm::dvec3 transmittance_of(const Look& look, double strands, const glm::dvec3& colour) {
  return glm::exp(-strands * stopped(look, colour));
}

/// Approximate share of the light from all directions that reaches a point below an optical depth of `a`.
inline double from_all_around(double a) {
  return (1 + a) / (1 + (std::numbers::pi / 2 + 1) * a + 1.21 * a * a + 0.5 * a * a * a);
}

/// Length of the path out of the fur, over the height of the fur above. The fur covers a ball to a tenth of its radius;
/// the path starts (1 - s) of the fur's height below its surface.
inline double exit_path_length(const Case& c, const glm::dvec3& direction) {
  const double facing = glm::dot(glm::dvec3(c.normal), direction), below = 0.1 * (1 - double(c.height)) + 0.005;
  return (std::sqrt(facing * facing + 2 * below) - facing) / below;
}

inline double strands_crossed(const Case& c, const glm::dvec3& direction) {
  const double along = glm::dot(glm::dvec3(c.tangent), direction);
  return double(c.above) * std::sqrt(1 - 0.92 * along * along) * exit_path_length(c, direction);
}

/// Strands that a ray to the light crosses. The view ray crosses none, so the strands that both rays share are taken
/// off: the fewer, the more the rays diverge across the strands, in sixths of a strand's width.
inline double strands_to_light(const Coat& coat, const Case& c, const glm::dvec3& to_light) {
  const glm::dvec3 tangent(c.tangent), to_camera(c.to_camera);
  const double to_cameras = strands_crossed(c, to_camera), to_lights = strands_crossed(c, to_light);
  const double width = (coat.width_root + coat.width_tip) / 2,
               by_width = coat.count * width * width / (coat.tile * coat.tile);
  const double widths = double(c.above) / by_width * std::max(glm::dot(tangent, glm::dvec3(c.normal)), 0.15);
  const double apart = glm::length(
      glm::cross(tangent, to_camera * exit_path_length(c, to_camera) - to_light * exit_path_length(c, to_light)));
  const double x = 6 * widths * apart;
  const double shared = (1 + x / 6) / (1 + 2 * x / 3 + x * x / 6);
  return std::max(to_lights - std::sqrt(to_cameras * to_lights) * shared, 0.0);
}

struct Arriving {
  glm::dvec3 to_light{0}, radiance{0};
};

inline Arriving arriving_from(const FurLight& light, const glm::dvec3& position) {
  if (light.kind == LightKind::directional) return {-glm::dvec3(light.direction), glm::dvec3(light.radiance)};
  const glm::dvec3 apart = glm::dvec3(light.position) - position;
  Arriving found{glm::normalize(apart), glm::dvec3(light.radiance) / glm::dot(apart, apart)};
  if (light.kind == LightKind::spot) {
    const double inside = glm::dot(-found.to_light, glm::dvec3(light.direction));
    const double edge = double(light.cone), full = double(light.soft_cone);
    found.radiance *= std::clamp((inside - edge) / (full - edge), 0.0, 1.0);
  }
  if (light.kind == LightKind::area)
    found.radiance *= std::max(-glm::dot(found.to_light, glm::dvec3(light.direction)), 0.0);
  return found;
}

struct Expected {
  glm::dvec3 light{0};
  glm::dvec3 direct{0}, unshadowed{0};  // light of lights alone
};

/// c = ka g C E + sum of [scattered] t B L, where t is the transmittance in the colour of the fur above and g = (1-e) o
/// + e. As `self_shadow` goes from 0 to 1, o goes from the height s to the ambient share that reaches the fibre.
inline Expected expected_light(const FurFrame& frame, const FibreShading& shading, const Case& c) {
  const Look& look = frame.look;
  const SphericalHarmonics around = irradiance_of(harmonics_of(frame.environment));
  const glm::dvec3 colour(c.colour), normal(c.normal);
  const std::size_t slice = std::min<std::size_t>(static_cast<std::size_t>(c.height * slice_count), slice_count - 1);
  const glm::dvec3 crossed = colour * glm::dvec3(colour_above(frame.coat())[slice]);
  const glm::dvec3 above = double(c.above) * stopped(look, crossed, 0.6);
  const glm::dvec3 reached{from_all_around(above.r), from_all_around(above.g), from_all_around(above.b)};
  const glm::dvec3 ambient = glm::mix(glm::dvec3(double(c.height)), reached, std::min(look.self_shadow, 1.0));
  const glm::dvec3 g = (1 - look.ambient_floor) * ambient + look.ambient_floor;
  Expected sum;
  for (const FurLight& light : frame.lights) {
    const Arriving from = arriving_from(light, glm::dvec3(c.position));
    const double facing = glm::dot(normal, from.to_light);
    const ScatterGeometry geometry{glm::dvec3(c.tangent), normal, from.to_light, glm::dvec3(c.to_camera)};
    const double behind = backlight_fade(look.shading, facing, look.back_attenuation);
    const glm::dvec3 whole = shading.scatter(geometry, colour, double(c.strand)) * from.radiance * behind;
    sum.direct += whole * transmittance_of(look, strands_to_light(frame.coat(), c, from.to_light), crossed);
    sum.unshadowed += whole;
  }
  sum.light = sum.direct + look.ambient * g * colour * glm::max(evaluate(around, normal), 0.0);
  return sum;
}

}  // namespace pelage::testing
