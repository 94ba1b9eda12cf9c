#include "server/maps/uv_corners.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

#include "base/clamped_index.h"
#include "protocol/commands/map.h"
#include "server/maps/encoding.h"
#include "server/maps/read_map.h"

namespace pelage {

namespace {

using glm::dvec2;
using glm::dvec3;

/// The orientation of a triangle in the texture.
struct Slope {
  dvec3 along_u{0};  // dP/du, twice the triangle's area long; 0 if it has no area in the texture
  double side = 1;
};

/// The sums of the slopes of the triangles around a corner, for plain and for mirrored ones.
struct Slopes {
  dvec3 plain{0}, mirrored{0};
  double plain_area = 0, mirrored_area = 0;

  void add(const Slope& slope) {
    (slope.side > 0 ? plain : mirrored) += slope.along_u;
    (slope.side > 0 ? plain_area : mirrored_area) += glm::length(slope.along_u);
  }
  Slope of_max() const { return mirrored_area > plain_area ? Slope{mirrored, -1} : Slope{plain, 1}; }
};

Slope slope_of(const Mesh& mesh, std::size_t t) {
  const glm::uvec3 v = mesh.triangles[t];
  const auto& uv = mesh.texture_uv[t];
  const dvec3 p(mesh.positions[v.x]), e1 = dvec3(mesh.positions[v.y]) - p, e2 = dvec3(mesh.positions[v.z]) - p;
  const dvec2 d1 = dvec2(uv[1]) - dvec2(uv[0]), d2 = dvec2(uv[2]) - dvec2(uv[0]);
  const double det = d1.x * d2.y - d1.y * d2.x;
  const dvec3 along = (det < 0 ? -1.0 : 1.0) * (e1 * d2.y - e2 * d1.y);
  const double length = glm::length(along);
  if (det == 0 || !(length > 0)) return {};
  return {glm::length(glm::cross(e1, e2)) / length * along, det < 0 ? -1.0 : 1.0};
}

/// A corner of a triangle; `number` is 3 * triangle + its index in the triangle.
struct Corner {
  std::uint32_t vertex;
  glm::vec2 uv;
  std::uint32_t number;

  auto key() const { return std::tuple(vertex, uv.x, uv.y); }
};

std::vector<Corner> sorted_corners(const Mesh& mesh) {
  std::vector<Corner> corners;
  corners.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      corners.push_back({mesh.triangles[t][static_cast<int>(k)], mesh.texture_uv[t][k], 3 * t + k});
    }
  }
  std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
    return std::tuple_cat(a.key(), std::tuple(a.number)) < std::tuple_cat(b.key(), std::tuple(b.number));
  });
  return corners;
}

/// Sets the tangent space of a corner.
void set_tangent_space(UvCorner& corner, const Slope& slope, const Mesh& mesh) {
  corner.side = slope.side;
  const dvec3 tangent(mesh.tangents[corner.vertex]), normal(mesh.normals[corner.vertex]);
  const dvec2 axis(glm::dot(slope.along_u, tangent), glm::dot(slope.along_u, glm::cross(normal, tangent)));
  const double length = glm::length(axis);
  corner.mapped = length > 1e-9 * glm::length(slope.along_u);
  if (corner.mapped) corner.axis = axis / length;
}

}  // namespace

UvCorners make_uv_corners(const Mesh& mesh) {
  std::vector<Slope> slopes(mesh.triangles.size());
  for (std::size_t t = 0; t < slopes.size(); ++t) slopes[t] = slope_of(mesh, t);
  const std::vector<Corner> sorted = sorted_corners(mesh);
  UvCorners all;
  all.of_triangle.resize(mesh.triangles.size());
  all.first.assign(mesh.positions.size() + 1, 0);
  for (std::size_t i = 0; i < sorted.size();) {
    const Corner& one = sorted[i];
    Slopes around;
    const auto index = static_cast<std::uint32_t>(all.corners.size());
    for (; i < sorted.size() && sorted[i].key() == one.key(); ++i) {
      const std::uint32_t t = sorted[i].number / 3;
      all.of_triangle[t][static_cast<int>(sorted[i].number % 3)] = index;
      around.add(slopes[t]);
    }
    UvCorner& corner = all.corners.emplace_back(UvCorner{one.vertex, one.uv, {1, 0}, 1, false});
    set_tangent_space(corner, around.of_max(), mesh);
    ++all.first[one.vertex + 1];
  }
  for (std::size_t v = 0; v + 1 < all.first.size(); ++v) all.first[v + 1] += all.first[v];
  return all;
}

namespace {

constexpr std::size_t min_passes = 48, max_passes = 2000;
constexpr std::size_t max_corrections = 10'000'000;  // small models may take more than min_passes up to this
constexpr double relative_tolerance = 1e-6;          // relative to the value, or to 0.01 if that is larger
constexpr double min_squared_weights = 0.05;         // of covered pixels; below it a correction would become too large

/// Merges taps of the same pixel by adding their weights.
Taps merged(Taps taps) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = i + 1; k < 4; ++k) {
      if (taps.pixels[i] == taps.pixels[k]) taps.weights[i] += std::exchange(taps.weights[k], 0.0);
    }
  }
  return taps;
}

/// Returns the present value of a corner from its four pixels.
double current_value(const Taps& taps, int channel, const MapImage& image) {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) sum += taps.weights[i] * image.at(taps.pixels[i])[channel];
  return sum;
}

/// Returns the sum of the squared weights of covered pixels, which tells how well a corner can be corrected.
double covered_squared_weights(const Taps& taps, const MapImage& image) {
  double squared_weights = 0;
  for (std::size_t i = 0; i < 4; ++i)
    squared_weights += image.covered[taps.pixels[i]] * taps.weights[i] * taps.weights[i];
  return squared_weights;
}

/// Returns whether a pixel can still change in the direction of `residual`.
bool is_free(const MapImage& image, std::size_t pixel, int channel, double residual, double min, double max) {
  const double value = image.at(pixel)[channel];
  return image.covered[pixel] && (residual > 0 ? value < max : value > min);
}

/// Changes the free pixels as little as possible so that the corner's equation holds. If some reach a limit, repeats
/// that with those that are still free. Returns whether the equation did not hold before.
bool project(const Taps& taps, double wanted, int channel, double min, double max, MapImage& image) {
  const double tolerance = relative_tolerance * std::max(std::abs(wanted), 0.01);
  double residual = wanted - current_value(taps, channel, image);
  if (std::abs(residual) <= tolerance) return false;
  for (int round = 0; round < 4 && std::abs(residual) > tolerance; ++round) {
    double squared_weights = 0;  // sum of the squared weights of free pixels
    std::array<bool, 4> free{};
    for (std::size_t i = 0; i < 4; ++i) {
      free[i] = is_free(image, taps.pixels[i], channel, residual, min, max);
      if (free[i]) squared_weights += taps.weights[i] * taps.weights[i];
    }
    if (squared_weights == 0) return true;
    for (std::size_t i = 0; i < 4; ++i) {
      float& value = image.at(taps.pixels[i])[channel];
      if (free[i])
        value = static_cast<float>(std::clamp(value + residual * taps.weights[i] / squared_weights, min, max));
    }
    residual = wanted - current_value(taps, channel, image);
  }
  return true;
}

}  // namespace

void fit_corners(const UvCorners& uvs, std::span<const glm::vec4> values, glm::dvec4 min, glm::dvec4 max,
                 MapImage& image) {
  const std::size_t passes =
      std::clamp(max_corrections / std::max<std::size_t>(uvs.corners.size(), 1), min_passes, max_passes);
  bool moved = true;
  for (std::size_t pass = 0; pass < passes && moved; ++pass) {
    moved = false;
    for (std::size_t k = 0; k < uvs.corners.size(); ++k) {
      if (!uvs.corners[k].mapped) continue;
      const Taps taps = merged(taps_at(uvs.corners[k].uv, image.size, image.size));
      if (covered_squared_weights(taps, image) < min_squared_weights) continue;
      for (int c = 0; c < image.channels; ++c) moved = project(taps, values[k][c], c, min[c], max[c], image) || moved;
    }
  }
}

namespace {

constexpr int udims_of_row = 10;

glm::ivec2 square_of(const UvCorners& uvs, glm::uvec3 t) {
  const auto uv = [&](std::uint32_t k) { return dvec2(uvs.corners[k].uv); };
  const dvec2 square = glm::floor((uv(t.x) + uv(t.y) + uv(t.z)) / 3.0);
  constexpr int farthest = 1 << 24;  // beyond it 32-bit floats do not identify a square
  return {clamped_index(square.x, -farthest, farthest), clamped_index(square.y, -farthest, farthest)};
}

glm::ivec2 square_of(int udim) { return {(udim - first_udim) % udims_of_row, (udim - first_udim) / udims_of_row}; }

/// Returns the corners in `selected`, moved by `shift`.
UvCorners chosen(const UvCorners& uvs, const std::vector<bool>& selected, glm::vec2 shift) {
  UvCorners chosen;
  std::size_t corner = 0;
  for (std::uint32_t vertex = 0; vertex + 1 < uvs.first.size(); ++vertex) {
    chosen.first.push_back(static_cast<std::uint32_t>(chosen.corners.size()));
    for (; corner < uvs.first[vertex + 1]; ++corner) {
      if (!selected[corner]) continue;
      chosen.corners.push_back(uvs.corners[corner]);
      chosen.corners.back().uv += shift;
    }
  }
  chosen.first.push_back(static_cast<std::uint32_t>(chosen.corners.size()));
  return chosen;
}

}  // namespace

UvCorners in_udim(UvCorners uvs, int tile) {
  if (tile == 0) return uvs;
  const glm::ivec2 square = square_of(tile);
  std::vector<glm::uvec3> triangles;
  std::vector<bool> selected(uvs.corners.size(), false);
  for (const glm::uvec3 t : uvs.of_triangle) {
    if (square_of(uvs, t) != square) continue;
    triangles.push_back(t);
    selected[t.x] = selected[t.y] = selected[t.z] = true;
  }
  UvCorners inside = chosen(uvs, selected, -glm::vec2(square));
  std::vector<std::uint32_t> number(uvs.corners.size());
  for (std::uint32_t k = 0, next = 0; k < selected.size(); ++k) number[k] = selected[k] ? next++ : 0;
  for (const glm::uvec3 t : triangles) inside.of_triangle.emplace_back(number[t.x], number[t.y], number[t.z]);
  return inside;
}

std::vector<int> udims_of(const UvCorners& uvs) {
  std::set<int> tiles;
  for (const glm::uvec3 t : uvs.of_triangle) {
    const glm::ivec2 square = square_of(uvs, t);
    const std::int64_t tile = first_udim + square.x + std::int64_t{udims_of_row} * square.y;
    if (square.x >= 0 && square.x < udims_of_row && square.y >= 0 && tile <= last_udim)
      tiles.insert(static_cast<int>(tile));
  }
  return {tiles.begin(), tiles.end()};
}

}  // namespace pelage
