#include "renderer/eye/caustics.h"

#include <algorithm>
#include <cmath>

#include "renderer/eye/optics.h"

namespace pelage {

namespace {

constexpr int rays_across = 160;  // of the light's beam

/// Shares a ray's flux among the four texels around the place, both in [0, caustic_texels].
void splat(float* map, double x, double y, double flux) {
  constexpr double last = caustic_texels - 1;
  x = std::clamp(x - 0.5, 0.0, last), y = std::clamp(y - 0.5, 0.0, last);
  const int i = std::min(static_cast<int>(x), caustic_texels - 2);
  const int j = std::min(static_cast<int>(y), caustic_texels - 2);
  const double u = x - i, v = y - j;
  float* texel = map + j * caustic_texels + i;
  texel[0] += static_cast<float>(flux * (1 - u) * (1 - v));
  texel[1] += static_cast<float>(flux * u * (1 - v));
  texel[caustic_texels] += static_cast<float>(flux * (1 - u) * v);
  texel[caustic_texels + 1] += static_cast<float>(flux * u * v);
}

/// Sends a beam of parallel light through the cornea.
void gather(const EyeShape& shape, double angle, float* map) {
  const glm::dvec3 to_light(std::sin(angle), 0, std::cos(angle)), across(std::cos(angle), 0, -std::sin(angle));
  const glm::dvec3 centre(0, 0, shape.cornea_centre);
  const double step = 2 * shape.cornea_radius / rays_across, texel = 2 * shape.iris_radius / caustic_texels;
  for (int j = 0; j < rays_across; ++j) {
    for (int i = 0; i < rays_across; ++i) {
      const glm::dvec2 at = (glm::dvec2(i, j) + 0.5) * step - shape.cornea_radius;
      const double height = shape.cornea_radius * shape.cornea_radius - glm::dot(at, at);
      if (height <= 0) continue;
      const glm::dvec3 away = at.x * across + glm::dvec3(0, at.y, 0) + std::sqrt(height) * to_light;
      if (centre.z + away.z < shape.limbus) continue;  // beside the cornea
      const glm::dvec3 normal = away / shape.cornea_radius;
      const auto inside = refract_into(-to_light, normal, shape.refraction);
      if (!inside || inside->z > -1e-6) continue;
      const glm::dvec3 hit = centre + away + *inside * ((centre.z + away.z - shape.iris_plane) / -inside->z);
      if (std::hypot(hit.x, hit.y) > shape.iris_radius) continue;  // on the wall of the chamber
      const double flux = step * step * (1 - fresnel(glm::dot(normal, to_light), shape.refraction));
      splat(map, hit.x / texel + 0.5 * caustic_texels, hit.y / texel + 0.5 * caustic_texels, flux / (texel * texel));
    }
  }
}

}  // namespace

std::vector<float> gather_caustics(const EyeShape& shape) {
  constexpr std::size_t texels = caustic_texels * caustic_texels;
  std::vector<float> maps(texels * caustic_angles);
  for (int k = 0; k < caustic_angles; ++k) {
    gather(shape, caustic_reach * k / (caustic_angles - 1), maps.data() + texels * static_cast<std::size_t>(k));
  }
  return maps;
}

}  // namespace pelage
