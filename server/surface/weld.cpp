#include "server/surface/weld.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <numeric>
#include <span>
#include <unordered_map>

#include "base/limits.h"
#include "base/random.h"

namespace pelage {

Placement placement_of(const std::vector<glm::dvec3>& positions) {
  assert(!positions.empty());
  Placement placement;
  placement.low = placement.high = positions.front();
  for (const glm::dvec3& p : positions) {
    placement.low = glm::min(placement.low, p);
    placement.high = glm::max(placement.high, p);
  }
  const glm::dvec3 half = placement.high / 2.0 - placement.low / 2.0;
  placement.centre = placement.low + half;
  // Scales by the longest side first, so that squares of tiny extents do not underflow.
  const double longest = 2 * glm::max(half.x, glm::max(half.y, half.z));
  placement.size = longest > 0 ? longest * glm::length(2.0 * half / longest) : 0;
  return placement;
}

std::size_t drop_repeated(Soup& soup) {
  std::vector<std::array<std::uint32_t, 4>> keys;  // sorted vertices, then the triangle
  for (std::uint32_t t = 0; t < soup.triangles.size(); ++t) {
    std::array<std::uint32_t, 4> key = {soup.triangles[t].x, soup.triangles[t].y, soup.triangles[t].z, t};
    std::sort(key.begin(), key.begin() + 3);
    keys.push_back(key);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<bool> repeated(keys.size(), false);
  for (std::size_t i = 1; i < keys.size(); ++i) {
    repeated[keys[i][3]] = std::equal(keys[i].begin(), keys[i].begin() + 3, keys[i - 1].begin());
  }
  Soup remaining;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    if (!repeated[t]) remaining.add(soup.triangles[t], soup.corners[t], soup.faces[t]);
  }
  const std::size_t dropped = soup.triangles.size() - remaining.triangles.size();
  remaining.positions = std::move(soup.positions);
  remaining.sources = std::move(soup.sources);
  soup = std::move(remaining);
  return dropped;
}

void drop_unused(Soup& soup) {
  constexpr std::uint32_t unused = 0xffffffff;
  std::vector<std::uint32_t> renumbered(soup.positions.size(), unused);
  for (const glm::uvec3& t : soup.triangles) renumbered[t.x] = renumbered[t.y] = renumbered[t.z] = 0;
  std::uint32_t count = 0;
  for (std::uint32_t v = 0; v < renumbered.size(); ++v) {
    if (renumbered[v] == unused) continue;
    soup.positions[count] = soup.positions[v];
    soup.sources[count] = soup.sources[v];
    renumbered[v] = count++;
  }
  soup.positions.resize(count);
  soup.sources.resize(count);
  for (glm::uvec3& t : soup.triangles) t = {renumbered[t.x], renumbered[t.y], renumbered[t.z]};
}

std::size_t count_parts(const Soup& soup) {
  std::vector<std::uint32_t> parent(soup.positions.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  std::size_t parts = soup.positions.size();
  for (const glm::uvec3& t : soup.triangles) {
    for (int k = 1; k < 3; ++k) {
      const std::uint32_t a = root(t[0]), b = root(t[k]);
      if (a == b) continue;
      parent[std::max(a, b)] = std::min(a, b);
      --parts;
    }
  }
  return parts;
}

namespace {

struct PositionHash {
  std::size_t operator()(const glm::dvec3& p) const {
    std::uint64_t hash = 0;
    for (int i = 0; i < 3; ++i) hash = mix_bits(hash ^ std::bit_cast<std::uint64_t>(p[i]));
    return hash;
  }
};

double largest_coordinate(glm::dvec3 p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

BadFace validity_of(const RawModel& raw, const Polygons::Face& face) {
  if (face.size < 3) return BadFace::corners;
  const auto corners = std::span(raw.corners).subspan(face.begin, face.size);
  const auto all = [&](auto good) { return std::all_of(corners.begin(), corners.end(), good); };
  if (!all([&](std::uint32_t v) { return v < raw.positions.size(); })) return BadFace::vertices;
  return all([&](std::uint32_t v) { return is_finite(raw.positions[v]); }) ? BadFace::none : BadFace::numbers;
}

/// Makes the welded vertices in the order in which faces use them.
class Welder {
 public:
  Welder(const RawModel& raw, const glm::dmat3& rotation, Polygons& out) : raw_(raw), rotation_(rotation), out_(out) {
    out_.vertex.assign(raw.positions.size(), no_position);
  }

  /// Adds a vertex; returns false if a coordinate is over the limit.
  bool add(std::uint32_t source) {
    if (out_.vertex[source] != no_position) return true;
    if (largest_coordinate(raw_.positions[source]) > limits::model_coordinate) return false;
    const glm::dvec3 position = rotation_ * raw_.positions[source] + 0.0;  // -0 + 0 is 0
    const auto [entry, is_new] = known_.try_emplace(position, static_cast<std::uint32_t>(out_.positions.size()));
    if (is_new) {
      out_.positions.push_back(position);
      out_.sources.push_back(source);
    }
    out_.vertex[source] = entry->second;
    ++out_.used;
    return true;
  }

 private:
  const RawModel& raw_;
  const glm::dmat3& rotation_;
  Polygons& out_;
  std::unordered_map<glm::dvec3, std::uint32_t, PositionHash> known_;
};

}  // namespace

Result<Polygons> weld(const RawModel& raw, const glm::dmat3& rotation) {
  Polygons polygons;
  Welder welder(raw, rotation, polygons);
  std::uint32_t begin = 0;
  for (std::uint32_t f = 0; f < raw.face_sizes.size(); ++f) {
    const Polygons::Face face{f, begin, raw.face_sizes[f]};
    begin += face.size;
    const BadFace bad = validity_of(raw, face);
    ++polygons.bad_faces[static_cast<std::size_t>(bad)];
    if (bad != BadFace::none) continue;
    for (std::uint32_t i = face.begin; i < begin; ++i) {
      if (!welder.add(raw.corners[i])) {
        return failure(Code::invalid, "The model has coordinates over 1e20.", "", "at most 1e20");
      }
    }
    polygons.faces.push_back(face);
  }
  return polygons;
}

namespace {

bool is_colour(glm::vec3 c) {
  return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z) && c.x >= 0 && c.y >= 0 && c.z >= 0;
}

bool is_usable_uv(glm::dvec2 uv) {
  constexpr double farthest = 1e6;  // farther away 32-bit coordinates are too coarse for a texture
  return std::abs(uv.x) <= farthest && std::abs(uv.y) <= farthest;
}

/// Returns whether the file has no texture coordinates at the corner.
bool has_no_uv(glm::dvec2 uv) { return std::isnan(uv.x); }

LookCorner look_of(const RawModel& raw, const RawMaterial& material, std::uint32_t corner) {
  LookCorner look;
  if (is_colour(material.base_colour)) look.colour = material.base_colour;
  if (!raw.corner_colour.empty() && is_colour(glm::vec3(raw.corner_colour[corner]))) {
    look.colour *= glm::vec3(raw.corner_colour[corner]);
  }
  if (!raw.corner_uv.empty() && is_usable_uv(raw.corner_uv[corner])) {
    look.uv = glm::vec2(raw.corner_uv[corner]);
    look.image = material.image;
  }
  return look;
}

/// Returns the appearance of a triangle, which is textured at all corners or at none.
std::array<LookCorner, 3> look_of_triangle(const RawModel& raw, const RawMaterial& material, glm::uvec3 corners) {
  std::array<LookCorner, 3> looks;
  for (std::size_t k = 0; k < 3; ++k) looks[k] = look_of(raw, material, corners[static_cast<int>(k)]);
  const bool all_textured =
      std::all_of(looks.begin(), looks.end(), [](const LookCorner& look) { return look.image >= 0; });
  for (LookCorner& look : looks) look.image = all_textured ? look.image : -1;
  return looks;
}

}  // namespace

std::vector<std::array<LookCorner, 3>> look_corners(const RawModel& raw, const Soup& soup) {
  std::vector<std::array<LookCorner, 3>> looks;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    const RawMaterial material =
        raw.face_material.empty() ? RawMaterial() : raw.materials[raw.face_material[soup.faces[t]]];
    looks.push_back(look_of_triangle(raw, material, soup.corners[t]));
  }
  const glm::vec3 first = looks.front()[0].colour;
  const bool first_is_grey = first.x == first.y && first.y == first.z;
  const auto is_plain = [&](const LookCorner& look) { return look.image < 0 && look.colour == first; };
  const bool all_plain = std::all_of(looks.begin(), looks.end(), [&](const std::array<LookCorner, 3>& triangle) {
    return std::all_of(triangle.begin(), triangle.end(), is_plain);
  });
  if (first_is_grey && all_plain) looks.clear();
  return looks;
}

std::size_t count_unusable_uvs(const RawModel& raw, const Soup& soup) {
  if (raw.corner_uv.empty()) return 0;
  const auto is_unusable = [&](std::uint32_t corner) {
    return !has_no_uv(raw.corner_uv[corner]) && !is_usable_uv(raw.corner_uv[corner]);
  };
  return static_cast<std::size_t>(
      std::count_if(soup.corners.begin(), soup.corners.end(), [&](const glm::uvec3& corners) {
        return is_unusable(corners.x) || is_unusable(corners.y) || is_unusable(corners.z);
      }));
}

std::vector<std::array<glm::vec2, 3>> texture_corners(const RawModel& raw, const Soup& soup) {
  std::vector<std::array<glm::vec2, 3>> texture;
  if (raw.corner_uv.empty()) return texture;
  texture.resize(soup.corners.size(), {glm::vec2(0), glm::vec2(0), glm::vec2(0)});
  for (std::size_t t = 0; t < texture.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec2 uv = raw.corner_uv[soup.corners[t][static_cast<int>(k)]];
      if (is_usable_uv(uv)) texture[t][k] = glm::vec2(uv);
    }
  }
  return texture;
}

}  // namespace pelage
