#include "server/patches/patch_weights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

#include "server/surface/value_noise.h"

namespace pelage {

namespace {

/// A vertex within reach of another cell than its own.
struct Reach {
  std::uint32_t vertex, patch;
  double distance;  // from the patch's cell, made irregular, sizes
};

/// Finds what lies around each cell.
class ReachFinder {
 public:
  ReachFinder(const Mesh& mesh, const VertexGraph& graph, const Cells& cells, double width)
      : mesh_(mesh), graph_(graph), cells_(cells), width_(width),
        distance_(mesh.positions.size(), std::numeric_limits<double>::infinity()) {}

  /// By rising vertex, then patch.
  std::vector<Reach> find_all() {
    const Adjacency members = members_of(cells_);
    for (std::uint32_t c = 0; c < cells_.count; ++c) find_around(c, members.of(c));
    std::sort(found_.begin(), found_.end(), [](const Reach& a, const Reach& b) {
      return std::pair(a.vertex, a.patch) < std::pair(b.vertex, b.patch);
    });
    return std::move(found_);
  }

 private:
  using Visit = std::pair<double, std::uint32_t>;

  void find_around(std::uint32_t cell, std::span<const std::uint32_t> members) {
    std::vector<std::uint32_t> touched;
    for (const std::uint32_t v : members) step_out(cell, v, 0, touched);
    while (!front_.empty()) {
      const auto [so_far, v] = front_.top();
      front_.pop();
      if (so_far == distance_[v]) step_out(cell, v, so_far, touched);
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    for (const std::uint32_t v : touched) {
      const double reach = distance_[v] * (1 + raggedness(v, cell));
      if (reach < width_) found_.push_back({v, cell, reach});
      distance_[v] = std::numeric_limits<double>::infinity();
    }
  }

  void step_out(std::uint32_t cell, std::uint32_t from, double so_far, std::vector<std::uint32_t>& touched) {
    for (const std::uint32_t next : graph_.neighbours.of(from)) {
      if (cells_.cell[next] == cell) continue;
      const glm::dvec3 a(mesh_.positions[from]), b(mesh_.positions[next]);
      const double reached = so_far + glm::distance(a, b);
      if (!(reached < distance_[next]) || reached > width_ / (1 - ragged_share)) continue;
      distance_[next] = reached;
      touched.push_back(next);
      front_.emplace(reached, next);
    }
  }

  static constexpr double ragged_share = 0.6;

  double raggedness(std::uint32_t vertex, std::uint32_t cell) const {
    constexpr double length = 0.012;  // of the noise, sizes: some strands wide
    return ragged_share * value_noise(glm::dvec3(mesh_.positions[vertex]) / length, cell + 2);
  }

  const Mesh& mesh_;
  const VertexGraph& graph_;
  const Cells& cells_;
  double width_;
  std::vector<double> distance_;
  std::vector<Reach> found_;
  std::priority_queue<Visit, std::vector<Visit>, std::greater<>> front_;
};

/// What a patch counts before shares are normalised, at this distance from its cell.
double fall_off(double distance, double width) {
  const double x = std::clamp(1 - distance / width, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

VertexShares normalised(const Cells& cells, const std::vector<Reach>& reaches, double width) {
  constexpr double negligible = 0.03;
  VertexShares result;
  result.begin.push_back(0);
  std::size_t next = 0;
  for (std::uint32_t v = 0; v < cells.cell.size(); ++v) {
    const auto first = static_cast<std::ptrdiff_t>(result.shares.size());
    result.shares.push_back({cells.cell[v], 1});
    float sum = 1;
    for (; next < reaches.size() && reaches[next].vertex == v; ++next) {
      const double weight = width > 0 ? fall_off(reaches[next].distance, width) : 0;
      if (weight < negligible) continue;
      result.shares.push_back({reaches[next].patch, static_cast<float>(weight)});
      sum += static_cast<float>(weight);
    }
    std::sort(result.shares.begin() + first, result.shares.end(),
              [](const PatchShare& a, const PatchShare& b) { return a.patch < b.patch; });
    for (auto share = result.shares.begin() + first; share != result.shares.end(); ++share) share->weight /= sum;
    result.begin.push_back(static_cast<std::uint32_t>(result.shares.size()));
  }
  return result;
}

/// Area of all pieces over the area of the surface.
double area_factor(const Mesh& mesh, const VertexShares& shares) {
  double pieces = 0, surface = 0;
  std::vector<std::uint32_t> patches;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    const double twice = glm::length(glm::cross(b - a, c - a));
    patches_at(shares, t, patches);
    pieces += twice * static_cast<double>(patches.size());
    surface += twice;
  }
  return surface > 0 ? pieces / surface : 1;
}

}  // namespace

VertexShares share_vertices(const Mesh& mesh, const VertexGraph& graph, const Cells& cells, const Overlap& overlap) {
  constexpr int halvings = 6;
  const std::vector<Reach> reaches = ReachFinder(mesh, graph, cells, overlap.width).find_all();
  VertexShares best = normalised(cells, reaches, overlap.width);
  if (area_factor(mesh, best) <= overlap.area_factor) return best;
  best = normalised(cells, reaches, 0);
  double low = 0, high = overlap.width;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (low + high) / 2;
    VertexShares shares = normalised(cells, reaches, middle);
    const bool fits = area_factor(mesh, shares) <= overlap.area_factor;
    (fits ? low : high) = middle;
    if (fits) best = std::move(shares);
  }
  return best;
}

void patches_at(const VertexShares& shares, const glm::uvec3& triangle, std::vector<std::uint32_t>& patches) {
  patches.clear();
  for (int k = 0; k < 3; ++k) {
    for (const PatchShare& share : shares.of(triangle[k])) patches.push_back(share.patch);
  }
  std::sort(patches.begin(), patches.end());
  patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
}

}  // namespace pelage
