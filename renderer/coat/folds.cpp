#include "renderer/coat/folds.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "protocol/base/lean_curve.h"

namespace pelage {

namespace {

constexpr int heights = 8;
constexpr double no_fold = 2;
constexpr double min_width = 0.1;  // of a shell that is limited, over that of its triangle
constexpr int max_passes = 32, halvings = 10;

double height_of(int k) { return static_cast<double>(k + 1) / heights; }

/// How a strand moves its root's shell at a height, for a factor on its inclination.
glm::dvec3 shift_of(const FurredSurface& fur, std::uint32_t vertex, double factor, double height) {
  const glm::dvec3 normal(fur.normals[vertex]), tangent(fur.tangents[vertex]);
  const auto [inclination, lean] = lean_of(glm::dvec2(fur.direction[vertex]), normal, tangent);
  const LeanPoint point = lean_point(fur.curve, std::min(factor * inclination, 1.0), fur.root_share, height);
  return static_cast<double>(fur.length[vertex]) * (point.across * lean + point.up * normal);
}

/// Two sides of a triangle in its own plane, and the plane; `area` is twice the triangle's, 0 for one without.
struct Flat {
  glm::dvec3 right, up;
  glm::dmat2 sides;
  double area = 0;
};

Flat flattened(const FurredSurface& fur, const glm::uvec3& corners) {
  const glm::dvec3 origin(fur.positions[corners.x]);
  const glm::dvec3 first = glm::dvec3(fur.positions[corners.y]) - origin;
  const glm::dvec3 second = glm::dvec3(fur.positions[corners.z]) - origin;
  const glm::dvec3 normal = glm::cross(first, second);
  const double longest = std::max(glm::dot(first, first), glm::dot(second, second)), area = glm::length(normal);
  if (!(area > 1e-12 * longest)) return {};
  const glm::dvec3 right = first / glm::length(first), up = glm::cross(normal / area, right);
  return {right, up, {{glm::length(first), 0}, {glm::dot(second, right), glm::dot(second, up)}}, area};
}

/// Whether a real eigenvalue of `map` is at most `least`. Two equal ones must not be lost to rounding.
bool turns_over(glm::dmat2 map, double min) {
  constexpr double rounding = 1e-3;
  map -= glm::dmat2(min);
  const double determinant = glm::determinant(map), trace = map[0][0] + map[1][1];
  return determinant <= 0 || (trace < 0 && trace * trace >= 4 * (1 - rounding) * determinant);
}

/// Whether the shell over a flattened triangle turns over when its corners move like that.
bool folds(const Flat& flat, const std::array<glm::dvec3, 3>& shifts, double min) {
  if (flat.area == 0) return false;
  const auto in_plane = [&](const glm::dvec3& v) { return glm::dvec2(glm::dot(v, flat.right), glm::dot(v, flat.up)); };
  const glm::dmat2 moved(flat.sides[0] + in_plane(shifts[1] - shifts[0]),
                         flat.sides[1] + in_plane(shifts[2] - shifts[0]));
  return turns_over(moved * glm::inverse(flat.sides), min);
}

/// Whether the shells over one triangle turn over at any height when all of its corners' factors are scaled.
bool folds_anywhere(const FurredSurface& fur, const glm::uvec3& corners, std::span<const float> factors, double scale) {
  const Flat flat = flattened(fur, corners);
  for (int k = 0; k < heights; ++k) {
    std::array<glm::dvec3, 3> shifts;
    for (int c = 0; c < 3; ++c) {
      shifts[static_cast<std::size_t>(c)] = shift_of(fur, corners[c], scale * factors[corners[c]], height_of(k));
    }
    if (folds(flat, shifts, min_width)) return true;
  }
  return false;
}

/// The largest scale of the corners' factors at which the triangle does not fold, to within one in a thousand.
double largest_scale(const FurredSurface& fur, const glm::uvec3& corners, std::span<const float> factors) {
  double low = 0, high = 1;
  for (int step = 0; step < halvings; ++step) {
    const double middle = (low + high) / 2;
    (folds_anywhere(fur, corners, factors, middle) ? high : low) = middle;
  }
  return low;
}

/// The lowest fold over each triangle with these factors. Height by height, so that vertices are moved once for each.
std::vector<double> heights_with(const FurredSurface& fur, std::span<const float> factors, double min) {
  std::vector<double> lowest(fur.triangles.size(), no_fold);
  std::vector<glm::dvec3> shifts(fur.positions.size());
  for (int k = heights - 1; k >= 0; --k) {
    for (std::uint32_t v = 0; v < shifts.size(); ++v) shifts[v] = shift_of(fur, v, factors[v], height_of(k));
    for (std::size_t t = 0; t < lowest.size(); ++t) {
      const glm::uvec3& corners = fur.triangles[t];
      const std::array<glm::dvec3, 3> moved{shifts[corners.x], shifts[corners.y], shifts[corners.z]};
      if (folds(flattened(fur, corners), moved, min)) lowest[t] = height_of(k);
    }
  }
  return lowest;
}

/// One pass: the factors around each triangle that folds are scaled until it does not. False where none can be.
bool limit_once(const FurredSurface& fur, std::vector<float>& factors) {
  const std::vector<double> lowest = heights_with(fur, factors, min_width);
  std::vector<float> scales(factors.size(), 1);
  bool any = false;
  for (std::size_t t = 0; t < lowest.size(); ++t) {
    if (lowest[t] == no_fold || folds_anywhere(fur, fur.triangles[t], factors, 0)) continue;
    any = true;
    const float scale = static_cast<float>(largest_scale(fur, fur.triangles[t], factors));
    for (int c = 0; c < 3; ++c) scales[fur.triangles[t][c]] = std::min(scales[fur.triangles[t][c]], scale);
  }
  for (std::size_t v = 0; v < factors.size(); ++v) factors[v] *= scales[v];
  return any;
}

}  // namespace

std::vector<double> fold_heights(const FurredSurface& surface) {
  assert(surface.positions.size() == surface.direction.size() && surface.positions.size() == surface.length.size());
  return heights_with(surface, std::vector<float>(surface.positions.size(), 1), 0);
}

std::size_t count_folds(const FurredSurface& surface) {
  const std::vector<double> lowest = fold_heights(surface);
  return static_cast<std::size_t>(std::count_if(lowest.begin(), lowest.end(), [](double h) { return h < no_fold; }));
}

std::vector<float> fold_limits(const FurredSurface& surface) {
  assert(surface.positions.size() == surface.direction.size() && surface.positions.size() == surface.length.size());
  std::vector<float> factors(surface.positions.size(), 1);
  int pass = 0;
  while (pass < max_passes && limit_once(surface, factors)) ++pass;
  return factors;
}

}  // namespace pelage
