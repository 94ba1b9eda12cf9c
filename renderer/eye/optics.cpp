#include "renderer/eye/optics.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace pelage {

std::optional<glm::dvec3> refract_into(glm::dvec3 along, glm::dvec3 normal, double index) {
  assert(index > 0);
  const double cosine = -glm::dot(along, normal), eta = 1 / index;
  const double squared = 1 - eta * eta * (1 - cosine * cosine);
  if (!(squared >= 0)) return std::nullopt;
  return eta * along + (eta * cosine - std::sqrt(squared)) * normal;
}

double fresnel(double cosine, double index) {
  assert(index >= 1);
  const double c = std::clamp(cosine, 0.0, 1.0);
  const double inside = std::sqrt(index * index - 1 + c * c);  // index times the cosine inside
  if (!(inside + c > 0)) return 0;                             // no surface at all, seen along it
  const double across = (c - inside) / (c + inside);
  const double along = (index * index * c - inside) / (index * index * c + inside);
  return 0.5 * (across * across + along * along);
}

double pupil_size(double luminance) {
  constexpr double iris_millimetres = 11.8;
  const double magnitude = std::log10(std::clamp(luminance, 1e-12, 1e12));
  return (4.9 - 3 * std::tanh(0.4 * magnitude)) / iris_millimetres;
}

}  // namespace pelage
