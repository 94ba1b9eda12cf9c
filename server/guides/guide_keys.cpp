#include "server/guides/guide_keys.h"

#include <algorithm>
#include <cmath>

#include "base/lean_curve.h"

namespace pelage {

namespace {

double length_of(const GuideCurve& curve) {
  double length = 0;
  for (std::size_t i = 1; i < curve.size(); ++i) length += glm::distance(curve[i - 1], curve[i]);
  return length;
}

/// Returns the inclination at which the tip is at this angle from the normal, seen from the root. Found by bisection,
/// since the angle rises with the inclination.
double inclination_at(const Coat& coat, double angle) {
  double low = 0, high = 1;
  for (int step = 0; step < 40; ++step) {
    const double middle = 0.5 * (low + high);
    const LeanPoint tip = lean_point(coat.lean_curve, middle, coat.root_share, 1);
    (std::atan2(tip.across, tip.up) < angle ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

Key key_of(const GuideCurve& curve, glm::dvec3 normal, const Coat& coat, double size) {
  constexpr double vanishing = 1e-9;
  Key key{.position = curve.front(), .length = std::min(length_of(curve) / size, 10.0)};
  const glm::dvec3 chord = curve.back() - curve.front();
  const double up = glm::dot(chord, normal);
  const glm::dvec3 along = chord - up * normal;
  const double across = glm::length(along);
  if (!(across > vanishing * glm::length(chord)) || !(across > 0)) {
    key.direction = normal, key.inclination = 0;
    return key;
  }
  key.direction = along / across;
  key.inclination = inclination_at(coat, std::atan2(across, up));
  return key;
}

}  // namespace

GuideKeys keys_of(const std::vector<GuideCurve>& curves, const Surface& surface, const Coat& coat) {
  const Mesh& mesh = surface.mesh();
  GuideKeys found;
  for (const GuideCurve& curve : curves) {
    const glm::dvec3 root = mesh.to_internal(curve.front());
    const SurfacePoint nearest = surface.nearest(root);
    if (!(glm::distance(root, surface.position(nearest)) <= guide_reach))  // also excludes NaN
      ++found.far;
    else
      found.keys.push_back(key_of(curve, surface.normal(nearest), coat, mesh.size));
  }
  return found;
}

std::vector<Key> thinned(const std::vector<Key>& keys, std::size_t count) {
  if (keys.size() <= count) return keys;
  std::vector<Key> kept;
  for (std::size_t i = 0; i < count; ++i) kept.push_back(keys[i * keys.size() / count]);
  return kept;
}

double sigma_between(std::size_t keys, const Mesh& mesh) {
  double area = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    area += glm::length(glm::cross(b - a, c - a)) / 2;
  }
  return std::max(std::sqrt(area / static_cast<double>(std::max<std::size_t>(keys, 1))), 1e-6);
}

}  // namespace pelage
