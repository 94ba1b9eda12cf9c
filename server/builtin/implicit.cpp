#include "server/builtin/implicit.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

#include "base/parallel.h"

namespace pelage {
namespace {

glm::dvec3 flattened(const RoundCone& cone, glm::dvec3 offset) {
  return offset + (cone.flatten - 1) * glm::dot(offset, cone.flat_axis) * cone.flat_axis;
}

glm::dvec3 unit_or(glm::dvec3 v, glm::dvec3 fallback) {
  const double length = glm::length(v);
  return length > 1e-300 ? v / length : fallback;
}

/// Returns the smaller of two distances with a quadratic fillet `width` wide.
DistanceSample smooth_min(const DistanceSample& p, const DistanceSample& q, double width) {
  const bool p_is_less = p.distance < q.distance;
  const DistanceSample& less = p_is_less ? p : q;
  const DistanceSample& more = p_is_less ? q : p;
  const double overlap = std::max(0.0, 1 - (more.distance - less.distance) / width);
  return {less.distance - 0.25 * width * overlap * overlap, glm::mix(less.gradient, more.gradient, 0.5 * overlap)};
}

DistanceSample negated(const DistanceSample& s) { return {-s.distance, -s.gradient}; }

}  // namespace

ImplicitSurface::PreparedCone ImplicitSurface::prepare_cone(const RoundCone& cone) {
  assert(cone.flatten >= 1);
  PreparedCone prepared;
  prepared.cone = cone;
  const glm::dvec3 span = flattened(cone, cone.b - cone.a);
  prepared.length = glm::length(span);
  if (prepared.length > 0) {
    prepared.axis = span / prepared.length;
    prepared.sine = (cone.radius_a - cone.radius_b) / prepared.length;
    assert(std::abs(prepared.sine) < 1);
    prepared.cosine = std::sqrt(1 - prepared.sine * prepared.sine);
  }
  prepared.hull = {0.5 * (cone.a + cone.b),
                   0.5 * glm::distance(cone.a, cone.b) + std::max(cone.radius_a, cone.radius_b)};
  return prepared;
}

ImplicitSurface::Part ImplicitSurface::make_part(const Volume& volume) {
  assert(!volume.cones.empty() && volume.width > 0 && volume.joint_width > 0);
  Part part{{}, volume.width, volume.joint_width, volume.blend, 1, {}};
  for (const RoundCone& cone : volume.cones) {
    part.cones.push_back(prepare_cone(cone));
    part.max_flat = std::max(part.max_flat, cone.flatten);
    part.hull.centre += part.cones.back().hull.centre / static_cast<double>(volume.cones.size());
  }
  for (const PreparedCone& prepared : part.cones) {
    const double reach =
        glm::distance(prepared.hull.centre, part.hull.centre) + prepared.hull.radius + volume.joint_width;
    part.hull.radius = std::max(part.hull.radius, reach);
  }
  return part;
}

ImplicitSurface::ImplicitSurface(const std::vector<Volume>& volumes) {
  assert(!volumes.empty() && volumes.front().blend == Blend::add);
  lower_ = upper_ = volumes.front().cones.front().a;
  for (const Volume& volume : volumes) {
    parts_.push_back(make_part(volume));
    if (volume.blend == Blend::add) extend_box(volume);
  }
}

void ImplicitSurface::extend_box(const Volume& volume) {
  // A fillet swells a surface by at most a quarter of its width.
  const double swell = 0.25 * (volume.width + volume.joint_width);
  for (const RoundCone& cone : volume.cones) {
    lower_ = glm::min(lower_, glm::min(cone.a - cone.radius_a, cone.b - cone.radius_b) - swell);
    upper_ = glm::max(upper_, glm::max(cone.a + cone.radius_a, cone.b + cone.radius_b) + swell);
  }
}

DistanceSample ImplicitSurface::sample_cone(const PreparedCone& prepared, glm::dvec3 position) {
  const RoundCone& cone = prepared.cone;
  const glm::dvec3 offset = flattened(cone, position - cone.a);
  const double along = glm::dot(offset, prepared.axis);
  const glm::dvec3 across = offset - along * prepared.axis;
  const double radial = glm::length(across);
  const double slant = prepared.cosine * along - prepared.sine * radial;

  DistanceSample flat;
  if (slant <= 0) {
    flat = {glm::length(offset) - cone.radius_a, unit_or(offset, prepared.axis)};
  } else if (slant >= prepared.cosine * prepared.length) {
    const glm::dvec3 from_b = offset - prepared.length * prepared.axis;
    flat = {glm::length(from_b) - cone.radius_b, unit_or(from_b, prepared.axis)};
  } else {
    flat = {prepared.cosine * radial + prepared.sine * along - cone.radius_a,
            prepared.cosine * unit_or(across, glm::dvec3(0)) + prepared.sine * prepared.axis};
  }
  // Dividing by the gradient's length gives a distance again, exact at the surface.
  const glm::dvec3 gradient = flattened(cone, flat.gradient);
  const double slope = std::max(glm::length(gradient), 1e-3);
  return {flat.distance / slope, gradient / slope};
}

DistanceSample ImplicitSurface::sample_part(const Part& part, glm::dvec3 position) {
  DistanceSample sum = sample_cone(part.cones.front(), position);
  for (std::size_t i = 1; i < part.cones.size(); ++i) {
    const PreparedCone& prepared = part.cones[i];
    const double gap = glm::distance(position, prepared.hull.centre) - prepared.hull.radius;
    if (gap / part.max_flat > sum.distance + part.joint_width) continue;
    sum = smooth_min(sum, sample_cone(prepared, position), part.joint_width);
  }
  return sum;
}

DistanceSample ImplicitSurface::sample(glm::dvec3 position) const {
  DistanceSample sum = sample_part(parts_.front(), position);
  for (std::size_t i = 1; i < parts_.size(); ++i) {
    const Part& part = parts_[i];
    const bool adds = part.blend == Blend::add;
    // A part too far away for its fillet changes nothing. Flattening can reduce a distance by max_flat.
    const double gap = (glm::distance(position, part.hull.centre) - part.hull.radius) / part.max_flat;
    if (gap > (adds ? sum.distance : -sum.distance) + part.width) continue;
    const DistanceSample other = sample_part(part, position);
    sum = adds ? smooth_min(sum, other, part.width) : negated(smooth_min(negated(sum), other, part.width));
  }
  return sum;
}

glm::dvec3 ImplicitSurface::project(glm::dvec3 position, double reach) const {
  for (int step = 0; step < 3; ++step) {
    const DistanceSample at = sample(position);
    const double slope = glm::length(at.gradient);
    if (slope < 0.1 || std::abs(at.distance) < 1e-9) break;
    position -= std::clamp(at.distance / slope, -reach, reach) / slope * at.gradient;
  }
  return position;
}

namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// Six tetrahedra around a cube's diagonal, all positively oriented; bits 0, 1, 2 of a corner are its x, y, z.
constexpr std::array<std::array<int, 4>, 6> kTetrahedra = {
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

// For each set of inside corners an even permutation that lists the smaller of the two sides first
// (the inside ones where both have two).
constexpr std::array<std::array<int, 4>, 16> kOrder = {{{0, 1, 2, 3},
                                                        {0, 1, 2, 3},
                                                        {1, 0, 3, 2},
                                                        {0, 1, 2, 3},
                                                        {2, 3, 0, 1},
                                                        {0, 2, 3, 1},
                                                        {1, 2, 0, 3},
                                                        {3, 2, 1, 0},
                                                        {3, 2, 1, 0},
                                                        {0, 3, 1, 2},
                                                        {1, 3, 2, 0},
                                                        {2, 3, 0, 1},
                                                        {2, 3, 0, 1},
                                                        {1, 0, 3, 2},
                                                        {0, 1, 2, 3},
                                                        {0, 1, 2, 3}}};

class Polygoniser {
 public:
  Polygoniser(const ImplicitSurface& surface, double cell) : cell_(cell), origin_(surface.lower() - 2 * cell) {
    count_ = glm::ivec3(glm::ceil((surface.upper() + 2 * cell - origin_) / cell)) + 1;
    distance_.resize(static_cast<std::size_t>(count_.x) * static_cast<std::size_t>(count_.y * count_.z));
    const glm::uvec3 blocks = (count_ + kBlock - 1) / kBlock;
    for_each_in_parallel(blocks.x * blocks.y * blocks.z, [&](std::uint32_t i) {
      const glm::uvec3 block{i % blocks.x, i / blocks.x % blocks.y, i / (blocks.x * blocks.y)};
      sample_block(surface, kBlock * glm::ivec3(block));
    });
    vertex_of_edge_.assign(7 * distance_.size(), kNone);
  }

  TriangleMesh run() {
    for (int z = 0; z + 1 < count_.z; ++z)
      for (int y = 0; y + 1 < count_.y; ++y)
        for (int x = 0; x + 1 < count_.x; ++x)
          for (const auto& corners : kTetrahedra) cut({x, y, z}, corners);
    return std::move(mesh_);
  }

 private:
  static constexpr int kBlock = 8;      // grid points along a side of a block
  static constexpr double kSafe = 0.4;  // the distance of a flattened volume may be too large, by less than 2

  /// Samples a block of grid points. Far from the surface all points have the same sign, and one sample is enough.
  void sample_block(const ImplicitSurface& surface, glm::ivec3 low) {
    const glm::ivec3 end = glm::min(low + kBlock, count_);
    const glm::dvec3 half = 0.5 * cell_ * glm::dvec3(end - 1 - low);
    const double middle = surface.sample(point(low) + half).distance;
    const bool far = kSafe * std::abs(middle) > glm::length(half) + 2 * cell_;
    for (int z = low.z; z < end.z; ++z) {
      for (int y = low.y; y < end.y; ++y) {
        double* row = &distance_[index({0, y, z})];
        if (far)
          std::fill(row + low.x, row + end.x, middle);
        else
          sample_row(surface, {low.x, y, z}, end.x, row);
      }
    }
  }

  /// Samples a row of grid points. Points that must have the same sign as a sample are skipped.
  void sample_row(const ImplicitSurface& surface, glm::ivec3 at, int end, double* row) {
    while (at.x < end) {
      const double distance = surface.sample(point(at)).distance;
      const int alike = std::clamp(static_cast<int>(kSafe * std::abs(distance) / cell_), 1, end - at.x);
      std::fill_n(row + at.x, alike, distance);
      at.x += alike;
    }
  }

  static glm::ivec3 shifted(glm::ivec3 cube, int corner) {
    return cube + glm::ivec3(corner & 1, (corner >> 1) & 1, corner >> 2);
  }
  glm::dvec3 point(glm::ivec3 at) const { return origin_ + cell_ * glm::dvec3(at); }
  std::size_t index(glm::ivec3 at) const {
    return (static_cast<std::size_t>(at.z) * static_cast<std::size_t>(count_.y) + static_cast<std::size_t>(at.y)) *
               static_cast<std::size_t>(count_.x) +
           static_cast<std::size_t>(at.x);
  }

  void cut(glm::ivec3 cube, const std::array<int, 4>& corners) {
    unsigned inside = 0;
    for (unsigned k = 0; k < 4; ++k) inside |= (distance_[index(shifted(cube, corners[k]))] < 0 ? 1u : 0u) << k;
    if (inside == 0 || inside == 15) return;
    const auto crossing = [&](std::size_t from, std::size_t to) {
      const auto& order = kOrder[inside];
      return vertex(cube, corners[static_cast<std::size_t>(order[from])], corners[static_cast<std::size_t>(order[to])]);
    };
    const bool two = inside == 3 || inside == 5 || inside == 6 || inside == 9 || inside == 10 || inside == 12;
    if (two) {
      const glm::uvec4 ring{crossing(0, 2), crossing(0, 3), crossing(1, 3), crossing(1, 2)};
      mesh_.triangles.emplace_back(ring.x, ring.y, ring.z);
      mesh_.triangles.emplace_back(ring.x, ring.z, ring.w);
      return;
    }
    const bool one_inside = inside == 1 || inside == 2 || inside == 4 || inside == 8;
    const glm::uvec3 face{crossing(0, 1), crossing(0, 2), crossing(0, 3)};
    mesh_.triangles.push_back(one_inside ? face : glm::uvec3(face.x, face.z, face.y));
  }

  /// Returns the vertex on the edge between two corners. In a tetrahedron the lower corner's bits are a subset of the
  /// higher one's.
  std::uint32_t vertex(glm::ivec3 cube, int from, int to) {
    const glm::ivec3 low = shifted(cube, std::min(from, to));
    const glm::ivec3 high = shifted(cube, std::max(from, to));
    const std::size_t edge = 7 * index(low) + static_cast<std::size_t>((from ^ to) - 1);
    if (vertex_of_edge_[edge] != kNone) return vertex_of_edge_[edge];
    const double at_low = distance_[index(low)], at_high = distance_[index(high)];
    // Keeps the vertex away from the corners, so that no triangle vanishes.
    const double share = std::clamp(at_low / (at_low - at_high), 0.1, 0.9);
    vertex_of_edge_[edge] = static_cast<std::uint32_t>(mesh_.positions.size());
    mesh_.positions.push_back(glm::mix(point(low), point(high), share));
    return vertex_of_edge_[edge];
  }

  double cell_;
  glm::dvec3 origin_;
  glm::ivec3 count_{0};
  std::vector<double> distance_;
  std::vector<std::uint32_t> vertex_of_edge_;  // for each grid point the edges to its 7 higher neighbours
  TriangleMesh mesh_;
};

std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t vertex) {
  while (parent[vertex] != vertex) vertex = parent[vertex] = parent[parent[vertex]];
  return vertex;
}

}  // namespace

TriangleMesh polygonise(const ImplicitSurface& surface, double cell) { return Polygoniser(surface, cell).run(); }

TriangleMesh largest_part(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.positions.size());
  std::iota(parent.begin(), parent.end(), 0u);
  for (const glm::uvec3& face : mesh.triangles)
    for (int k = 1; k < 3; ++k) parent[root_of(parent, face[k])] = root_of(parent, face.x);
  std::vector<std::size_t> count(parent.size(), 0);
  for (const glm::uvec3& face : mesh.triangles) ++count[root_of(parent, face.x)];
  const auto largest = static_cast<std::uint32_t>(std::max_element(count.begin(), count.end()) - count.begin());

  TriangleMesh part;
  std::vector<std::uint32_t> renamed(parent.size(), kNone);
  for (const glm::uvec3& face : mesh.triangles) {
    if (root_of(parent, face.x) != largest) continue;
    glm::uvec3& triangle = part.triangles.emplace_back();
    for (int k = 0; k < 3; ++k) {
      if (renamed[face[k]] == kNone) {
        renamed[face[k]] = static_cast<std::uint32_t>(part.positions.size());
        part.positions.push_back(mesh.positions[face[k]]);
      }
      triangle[k] = renamed[face[k]];
    }
  }
  return part;
}

}  // namespace pelage
