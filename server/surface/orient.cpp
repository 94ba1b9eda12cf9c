#include "server/surface/orient.h"

#include <array>
#include <cmath>
#include <utility>

#include "server/surface/adjacency.h"

namespace pelage {

namespace {

constexpr std::uint32_t no_triangle = 0xffffffff;

struct Neighbour {
  std::uint32_t triangle = no_triangle;
  bool agrees = true;  // whether both are wound the same way
};

using Neighbours = std::vector<std::array<Neighbour, 3>>;

Neighbours find_neighbours(const std::vector<glm::uvec3>& triangles, Orientation& report) {
  Neighbours neighbours(triangles.size());
  for_each_edge(sorted_sides(triangles), [&](std::span<const Side> edge) {
    if (edge.size() == 1) ++report.open_edges;
    if (edge.size() > 2) ++report.non_manifold_edges;
    if (edge.size() != 2) return;
    const bool agrees = edge[0].rising != edge[1].rising;
    neighbours[edge[0].triangle][edge[0].side] = {edge[1].triangle, agrees};
    neighbours[edge[1].triangle][edge[1].side] = {edge[0].triangle, agrees};
  });
  return neighbours;
}

/// Decides for each triangle whether it turns, part by part.
class Orienter {
 public:
  Orienter(const Soup& soup, Orientation& report)
      : soup_(soup),
        report_(report),
        neighbours_(find_neighbours(soup.triangles, report)),
        flip_(soup.triangles.size(), false),
        part_(soup.triangles.size(), no_triangle) {}

  std::vector<bool> decide() {
    for (std::uint32_t t = 0; t < soup_.triangles.size(); ++t) {
      if (part_[t] != no_triangle) continue;
      const std::vector<std::uint32_t> members = gather(t);
      if (!should_turn(members)) continue;
      for (std::uint32_t member : members) flip_[member] = !flip_[member];
    }
    return std::move(flip_);
  }

 private:
  /// The part of `seed`, its triangles turned so that they agree with the seed.
  std::vector<std::uint32_t> gather(std::uint32_t seed) {
    std::vector<std::uint32_t> members = {seed};
    part_[seed] = seed;
    for (std::size_t i = 0; i < members.size(); ++i) {
      const std::uint32_t t = members[i];
      for (const Neighbour& next : neighbours_[t]) {
        if (next.triangle == no_triangle) continue;
        const bool wanted = next.agrees ? flip_[t] : !flip_[t];
        if (part_[next.triangle] == no_triangle) {
          part_[next.triangle] = seed;
          flip_[next.triangle] = wanted;
          members.push_back(next.triangle);
        } else if (flip_[next.triangle] != wanted && t < next.triangle) {
          ++report_.one_sided_edges;
        }
      }
    }
    return members;
  }

  std::array<glm::dvec3, 3> corners(std::uint32_t t) const {
    const glm::uvec3 v = soup_.triangles[t];
    return {soup_.positions[v.x], soup_.positions[v.y], soup_.positions[v.z]};
  }

  bool should_turn(const std::vector<std::uint32_t>& members) const {
    constexpr double next_to_nothing = 1e-3;  // of the cube of the box's diagonal; a ball has 0.1
    std::vector<glm::dvec3> positions;
    for (std::uint32_t t : members) {
      for (const glm::dvec3& p : corners(t)) positions.push_back(p);
    }
    const Placement box = place(positions);
    double volume = 0, kept = 0, flipped = 0;
    for (std::uint32_t t : members) {
      const auto [a, b, c] = corners(t);
      const double sixfold = glm::dot(a - box.centre, glm::cross(b - box.centre, c - box.centre));
      volume += (flip_[t] ? -sixfold : sixfold) / 6;
      (flip_[t] ? flipped : kept) += glm::length(glm::cross(b - a, c - a));
    }
    if (std::abs(volume) > next_to_nothing * box.size * box.size * box.size) return volume < 0;
    return flipped > kept;
  }

  const Soup& soup_;
  Orientation& report_;
  Neighbours neighbours_;
  std::vector<bool> flip_;
  std::vector<std::uint32_t> part_;
};

}  // namespace

Orientation orient(Soup& soup) {
  Orientation report;
  const std::vector<bool> flip = Orienter(soup, report).decide();
  for (std::size_t t = 0; t < flip.size(); ++t) {
    if (!flip[t]) continue;
    std::swap(soup.triangles[t].y, soup.triangles[t].z);
    std::swap(soup.corners[t].y, soup.corners[t].z);
    ++report.flipped_triangles;
  }
  return report;
}

}  // namespace pelage
