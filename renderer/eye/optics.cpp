#include "renderer/eye/optics.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "renderer/shading/fresnel.h"

namespace pelage {

std::optional<glm::dvec3> refract_into(glm::dvec3 along, glm::dvec3 normal, double index) {
  assert(index > 0);
  const double cosine = -glm::dot(along, normal), eta = 1 / index;
  const double squared = 1 - eta * eta * (1 - cosine * cosine);
  if (!(squared >= 0)) return std::nullopt;
  return eta * along + (eta * cosine - std::sqrt(squared)) * normal;
}

double fresnel(double cosine, double index) {
  return index == 1 ? 0
                    : fresnel_dielectric(std::clamp(cosine, 0.0, 1.0), index);  // no surface at all reflects nothing
}

double pupil_size(double luminance) {
  constexpr double iris_millimetres = 11.8;
  const double magnitude = std::log10(std::clamp(luminance, 1e-12, 1e12));
  return (4.9 - 3 * std::tanh(0.4 * magnitude)) / iris_millimetres;
}

}  // namespace pelage
