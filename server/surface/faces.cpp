#include "server/surface/faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "server/surface/adjacency.h"

namespace pelage {

namespace {

using Indices = std::array<std::uint32_t, 3>;

constexpr std::size_t max_corners_for_ears = 128;

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

/// A polygon projected along the dominant axis of its mean normal, counter-clockwise, relative to its first corner.
class Polygon {
 public:
  Polygon(std::span<const std::uint32_t> vertices, const std::vector<glm::dvec3>& positions)
      : vertices_(vertices), positions_(positions) {
    for (std::uint32_t i = 0; i < vertices.size(); ++i) {
      if (vertices[i] != vertices[(i + 1) % vertices.size()]) ring_.push_back(i);
    }
    flatten();
  }

  std::vector<Indices> split() {
    if (ring_.size() == 4) split_quad();
    if (ring_.size() > 3 && (ring_.size() > max_corners_for_ears || is_convex())) split_fan();
    while (ring_.size() > 3) cut(find_ear());
    if (ring_.size() == 3) add(0, 1, 2);
    return std::move(triangles_);
  }

 private:
  glm::dvec3 position(std::size_t k) const { return positions_[vertices_[ring_[k]]]; }
  glm::dvec2 flat(std::size_t k) const { return flat_[ring_[k]]; }
  std::size_t after(std::size_t k) const { return k + 1 < ring_.size() ? k + 1 : 0; }
  std::size_t before(std::size_t k) const { return k > 0 ? k - 1 : ring_.size() - 1; }

  /// Twice the signed area of three corners of the ring.
  double turn(std::size_t a, std::size_t b, std::size_t c) const { return cross(flat(b) - flat(a), flat(c) - flat(a)); }

  void flatten() {
    if (ring_.size() < 3) return ring_.clear();
    const glm::dvec3 origin = position(0);
    glm::dvec3 normal(0);
    for (std::size_t k = 0; k < ring_.size(); ++k) {
      normal += glm::cross(position(k) - origin, position(after(k)) - origin);
    }
    const glm::dvec3 size = glm::abs(normal);
    const int drop = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    const int u = (drop + 1) % 3, v = (drop + 2) % 3;
    const double sign = normal[drop] < 0 ? -1 : 1;
    flat_.resize(vertices_.size());
    for (std::size_t k = 0; k < ring_.size(); ++k) {
      const glm::dvec3 p = position(k) - origin;
      flat_[ring_[k]] = {p[u], sign * p[v]};
    }
  }

  void add(std::size_t a, std::size_t b, std::size_t c) {
    if (!has_no_area(position(a), position(b), position(c))) triangles_.push_back({ring_[a], ring_[b], ring_[c]});
  }

  /// Returns whether the polygon is strictly convex: every corner turns left, and all of them together once around.
  bool is_convex() const {
    int sign_changes = 0;  // in the x of the sides; more than 2 if the polygon, like a star, goes around twice
    double last = 0;
    for (std::size_t k = 0; k < ring_.size(); ++k) {
      if (!(turn(before(k), k, after(k)) > 0)) return false;
      const double x = flat(after(k)).x - flat(k).x;
      if (x != 0 && last != 0 && (x > 0) != (last > 0)) ++sign_changes;
      if (x != 0) last = x;
    }
    return sign_changes <= 2;
  }

  void split_quad() {
    const bool first = turn(0, 1, 2) > 0 && turn(0, 2, 3) > 0, second = turn(1, 2, 3) > 0 && turn(1, 3, 0) > 0;
    if (!first && !second) return;
    const bool shorter = glm::length(position(0) - position(2)) <= glm::length(position(1) - position(3));
    const std::size_t start = first && (shorter || !second) ? 0 : 1;
    add(start, start + 1, start + 2);
    add(start, start + 2, (start + 3) % 4);
    ring_.clear();
  }

  void split_fan() {
    for (std::size_t k = 1; k + 1 < ring_.size(); ++k) add(0, k, k + 1);
    ring_.clear();
  }

  bool is_ear(std::size_t k) const {
    const std::size_t a = before(k), c = after(k);
    if (!(turn(a, k, c) > 0)) return false;
    for (std::size_t p = 0; p < ring_.size(); ++p) {
      const std::uint32_t vertex = vertices_[ring_[p]];
      const bool is_corner =
          vertex == vertices_[ring_[a]] || vertex == vertices_[ring_[k]] || vertex == vertices_[ring_[c]];
      if (!is_corner && turn(a, k, p) >= 0 && turn(k, c, p) >= 0 && turn(c, a, p) >= 0) return false;
    }
    return true;
  }

  /// Returns the next ear after the last one cut, or any corner if the polygon intersects itself and has no ear.
  std::size_t find_ear() {
    for (std::size_t step = 0; step < ring_.size(); ++step) {
      const std::size_t k = (next_ + step) % ring_.size();
      if (is_ear(k)) return k;
    }
    return next_ % ring_.size();
  }

  void cut(std::size_t k) {
    add(before(k), k, after(k));
    ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(k));
    next_ = k;
  }

  std::span<const std::uint32_t> vertices_;
  const std::vector<glm::dvec3>& positions_;
  std::vector<std::uint32_t> ring_;  // corners that remain
  std::vector<glm::dvec2> flat_;     // projected position of each corner
  std::size_t next_ = 1;
  std::vector<Indices> triangles_;
};

}  // namespace

bool has_no_area(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  constexpr double rounding = 1e-14;
  const glm::dvec3 ab = b - a, bc = c - b, ca = a - c;
  const double longest = std::sqrt(std::max({glm::dot(ab, ab), glm::dot(bc, bc), glm::dot(ca, ca)}));
  if (longest == 0) return true;
  return !(glm::length(glm::cross(ab / longest, -ca / longest)) > rounding);
}

std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const std::uint32_t> vertices,
                                                      const std::vector<glm::dvec3>& positions) {
  return Polygon(vertices, positions).split();
}

namespace {

constexpr std::uint32_t no_triangle = 0xffffffff;

struct Neighbour {
  std::uint32_t triangle = no_triangle;
  bool agrees = true;  // true if both have consistent winding
  bool open = false;   // true if the side has no other triangle
};

using Neighbours = std::vector<std::array<Neighbour, 3>>;

Neighbours find_neighbours(const std::vector<glm::uvec3>& triangles, Orientation& report) {
  Neighbours neighbours(triangles.size());
  for_each_edge(sorted_sides(triangles), [&](std::span<const Side> edge) {
    if (edge.size() == 1) ++report.open_edges, neighbours[edge[0].triangle][edge[0].side].open = true;
    if (edge.size() > 2) ++report.non_manifold_edges;
    if (edge.size() != 2) return;
    const bool agrees = edge[0].rising != edge[1].rising;
    neighbours[edge[0].triangle][edge[0].side] = {edge[1].triangle, agrees, false};
    neighbours[edge[1].triangle][edge[1].side] = {edge[0].triangle, agrees, false};
  });
  return neighbours;
}

/// Decides for each triangle, part by part, whether it is flipped.
class Orienter {
 public:
  Orienter(const Soup& soup, Orientation& report)
      : soup_(soup),
        report_(report),
        neighbours_(find_neighbours(soup.triangles, report)),
        flip_(soup.triangles.size(), false),
        part_(soup.triangles.size(), no_triangle) {}

  /// Returns for each triangle whether it is flipped. `flipped` holds the numbers of parts to turn inside out, from 1.
  std::vector<bool> decide(const std::vector<std::uint32_t>& flipped) {
    for (std::uint32_t t = 0; t < soup_.triangles.size(); ++t) {
      if (part_[t] != no_triangle) continue;
      const std::vector<std::uint32_t> members = gather(t);
      OrientedPart part{t, members.size(), box_of(members)};
      bool turn = should_flip(members, part);
      const auto number = static_cast<std::uint32_t>(report_.parts.size() + 1);
      if (std::find(flipped.begin(), flipped.end(), number) != flipped.end()) turn = !turn;
      for (std::uint32_t member : members) flip_[member] = flip_[member] != turn;
      report_.parts.push_back(part);
    }
    report_.part_of = std::move(part_);
    return std::move(flip_);
  }

 private:
  /// Collects the part of `seed` and flips its triangles so that their winding is consistent with the seed.
  std::vector<std::uint32_t> gather(std::uint32_t seed) {
    std::vector<std::uint32_t> members = {seed};
    const auto number = static_cast<std::uint32_t>(report_.parts.size());
    part_[seed] = number;
    for (std::size_t i = 0; i < members.size(); ++i) {
      const std::uint32_t t = members[i];
      for (const Neighbour& next : neighbours_[t]) {
        if (next.triangle == no_triangle) continue;
        const bool wanted = next.agrees ? flip_[t] : !flip_[t];
        if (part_[next.triangle] == no_triangle) {
          part_[next.triangle] = number;
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

  Placement box_of(const std::vector<std::uint32_t>& members) const {
    std::vector<glm::dvec3> positions;
    for (std::uint32_t t : members) {
      for (const glm::dvec3& p : corners(t)) positions.push_back(p);
    }
    return placement_of(positions);
  }

  /// Measures of a part's winding, with its current flips.
  struct Winding {
    double volume = 0;                  // signed, with respect to the middle of the box
    double unflipped = 0, flipped = 0;  // twice the areas of triangles with the file's winding, and of flipped ones
    double holes = 0;                   // twice the area of flat lids on the holes
    bool open = false;
  };

  Winding winding_of(const std::vector<std::uint32_t>& members, const Placement& box) const {
    Winding winding;
    for (std::uint32_t t : members) {
      const auto [a, b, c] = corners(t);
      const double sixfold = glm::dot(a - box.centre, glm::cross(b - box.centre, c - box.centre));
      winding.volume += (flip_[t] ? -sixfold : sixfold) / 6;
      (flip_[t] ? winding.flipped : winding.unflipped) += glm::length(glm::cross(b - a, c - a));
      for (const Neighbour& next : neighbours_[t]) winding.open = winding.open || next.open;
    }
    if (winding.open) winding.holes = holes_of(members);
    return winding;
  }

  /// Returns twice the area of flat lids on the part's holes. Open edges that share vertices surround a hole. The sum
  /// of the area vectors that they span with any point is twice the area vector of the lid, if they go around once.
  double holes_of(const std::vector<std::uint32_t>& members) const {
    struct Rim {
      std::uint32_t from, to;
    };
    std::vector<Rim> rims;
    std::map<std::uint32_t, std::uint32_t> parent;
    const auto root = [&](std::uint32_t v) {
      parent.try_emplace(v, v);
      while (parent[v] != v) v = parent[v] = parent[parent[v]];
      return v;
    };
    for (const std::uint32_t t : members) {
      for (int k = 0; k < 3; ++k) {
        if (!neighbours_[t][static_cast<std::size_t>(k)].open) continue;
        Rim rim{soup_.triangles[t][k], soup_.triangles[t][(k + 1) % 3]};
        if (flip_[t]) std::swap(rim.from, rim.to);
        parent[root(rim.from)] = root(rim.to);
        rims.push_back(rim);
      }
    }
    std::map<std::uint32_t, glm::dvec3> lids;
    for (const Rim& rim : rims) {
      const std::uint32_t hole = root(rim.from);
      const glm::dvec3 middle = soup_.positions[hole];
      glm::dvec3& lid = lids.try_emplace(hole, 0.0).first->second;
      lid += glm::cross(soup_.positions[rim.from] - middle, soup_.positions[rim.to] - middle);
    }
    double area = 0;
    for (const auto& [hole, lid] : lids) area += glm::length(lid);
    return area;
  }

  bool should_flip(const std::vector<std::uint32_t>& members, OrientedPart& part) const {
    constexpr double negligible_volume = 1e-3;    // relative to the cube of the box's diagonal; a ball has 0.1
    constexpr double small_holes = 0.05;          // relative to the part's area
    constexpr std::size_t enough_to_enclose = 8;  // triangles; the volume of fewer is meaningless
    const Winding winding = winding_of(members, part.box);
    const double size = part.box.size;
    const bool encloses = std::abs(winding.volume) > negligible_volume * size * size * size;
    const bool by_volume = winding.volume<0, by_area = winding.flipped> winding.unflipped;
    const bool agreed = winding.flipped == 0 || winding.unflipped == 0;
    const bool nearly_closed = encloses && winding.holes < small_holes * (winding.unflipped + winding.flipped);
    part.sheet = winding.open && !encloses && members.size() >= enough_to_enclose;
    if (winding.open && agreed && !nearly_closed) {
      part.doubtful = encloses && by_volume != by_area && members.size() >= enough_to_enclose;
      return by_area;
    }
    return encloses ? by_volume : by_area;
  }

  const Soup& soup_;
  Orientation& report_;
  Neighbours neighbours_;
  std::vector<bool> flip_;
  std::vector<std::uint32_t> part_;
};

}  // namespace

Orientation orient(Soup& soup, const std::vector<std::uint32_t>& flipped) {
  Orientation report;
  const std::vector<bool> flip = Orienter(soup, report).decide(flipped);
  for (std::size_t t = 0; t < flip.size(); ++t) {
    if (!flip[t]) continue;
    std::swap(soup.triangles[t].y, soup.triangles[t].z);
    std::swap(soup.corners[t].y, soup.corners[t].z);
    ++report.flipped_triangles;
  }
  return report;
}

}  // namespace pelage
