#include "renderer/eye/shape.h"

#include <algorithm>
#include <cmath>

namespace pelage {

namespace {

constexpr double white_light = 1000;  // candela per square metre, a bright room

double brightness(glm::vec3 radiance) { return glm::dot(glm::dvec3(radiance), glm::dvec3(0.2126, 0.7152, 0.0722)); }

/// What a light brings to a surface at the eye that faces where it looks.
double brought_by(const FurLight& light, const FurEye& eye) {
  glm::dvec3 to_light = -glm::dvec3(light.direction);
  double share = 1;
  if (light.kind != LightKind::directional) {
    const glm::dvec3 apart = glm::dvec3(light.position) - glm::dvec3(eye.position);
    const double square = std::max(glm::dot(apart, apart), 1e-8);
    to_light = apart / std::sqrt(square);
    share = 1 / square;
    if (light.kind != LightKind::point) {
      const double inside = -glm::dot(to_light, glm::dvec3(light.direction));
      share *= std::clamp((inside - light.cone) / std::max<double>(light.soft_cone - light.cone, 1e-6), 0.0, 1.0);
    }
  }
  return share * brightness(light.radiance) * std::max(0.0, glm::dot(to_light, glm::dvec3(eye.frame[2])));
}

}  // namespace

EyeShape shape_of(const FurEye& eye) {
  EyeShape shape;
  shape.iris_radius = eye.iris.size;
  shape.limbus = std::sqrt(1 - eye.iris.size * eye.iris.size);
  shape.cornea_radius = 1 / glm::mix(1.0, 1 / eye.iris.size, eye.bulge);
  const double square = shape.cornea_radius * shape.cornea_radius - eye.iris.size * eye.iris.size;
  shape.cornea_centre = shape.limbus - std::sqrt(std::max(square, 0.0));
  shape.iris_plane = shape.limbus - eye.iris.depth;
  shape.relief = std::min(eye.iris.relief, eye.iris.depth);  // no fibre reaches through the limbus
  shape.refraction = eye.refraction;
  return shape;
}

PupilAxes pupil_axes(PupilShape shape, double size) {
  if (shape == PupilShape::round) return {size, size};
  // Narrow in bright light and nearly as high as the iris; round once it is dilated.
  const double narrow = std::clamp(1.6 * size - 0.12, 0.0, 1.0);
  const double width = glm::mix(narrow, size, size), height = glm::mix(0.50 * std::min(1.0, 12 * size), 1.0, size);
  return {width, height};
}

double luminance_at(const FurEye& eye, const FurFrame& frame) {
  double sum = frame.look.ambient;
  for (const FurLight& light : frame.lights) sum += brought_by(light, eye);
  return white_light * sum;
}

}  // namespace pelage
