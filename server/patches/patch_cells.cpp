#include "server/patches/patch_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <queue>
#include <utility>

#include "server/surface/value_noise.h"

namespace pelage {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The vertices still to visit, nearest first, lower numbers first on ties.
using Front = std::priority_queue<std::pair<double, std::uint32_t>, std::vector<std::pair<double, std::uint32_t>>,
                                  std::greater<>>;

double angle_between(glm::dvec3 a, glm::dvec3 b) { return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)); }

/// Returns the cost of a step: its length and its bending, so that ears and toes are far enough away to get seeds of
/// their own. Noise keeps borders from running straight.
double step_cost(const Mesh& mesh, std::uint32_t from, std::uint32_t to) {
  constexpr double bend_length = 0.08, noise_length = 0.03, noise_share = 0.4;
  const glm::dvec3 a(mesh.positions[from]), b(mesh.positions[to]);
  const double bend = angle_between(glm::dvec3(mesh.normals[from]), glm::dvec3(mesh.normals[to]));
  const double noise = value_noise((a + b) * (0.5 / noise_length), 1);
  return (glm::distance(a, b) + bend_length * bend) * (1 + noise_share * noise);
}

/// Returns whether a cell of these members has few enough vertices, and nearly all of its area faces about one
/// direction.
bool within_limits(const Mesh& mesh, const VertexGraph& graph, std::span<const std::uint32_t> members,
                   const CellLimits& limits) {
  if (members.size() == 1) return true;
  if (members.size() > limits.vertices) return false;
  glm::dvec3 sum(0);
  double area = 0, outside = 0;
  for (const std::uint32_t v : members) {
    sum += graph.vertex_areas[v] * glm::dvec3(mesh.normals[v]);
    area += graph.vertex_areas[v];
  }
  const double smallest = std::cos(glm::radians(limits.cone_degrees)) * glm::length(sum);
  for (const std::uint32_t v : members) {
    if (!(glm::dot(glm::dvec3(mesh.normals[v]), sum) > smallest)) outside += graph.vertex_areas[v];
  }
  return outside <= 0.01 * area;
}

/// Grows cells from seeds; a vertex belongs to the seed that is cheapest to reach.
class CellGrower {
 public:
  CellGrower(const Mesh& mesh, const VertexGraph& graph, const CellLimits& limits)
      : mesh_(mesh), graph_(graph), limits_(limits), cost_(mesh.positions.size(), infinite) {
    cells_.cell.resize(mesh.positions.size());
    for (std::uint32_t v = 0; v < cost_.size(); ++v) {
      if (cost_[v] == infinite) add_seed(v), grow();
    }
  }

  Cells partition() {
    split_until_good();
    for (int i = 0; i < 3; ++i) centre_seeds();
    split_until_good();
    return std::move(cells_);
  }

 private:
  void add_seed(std::uint32_t vertex) {
    cost_[vertex] = 0;
    cells_.cell[vertex] = cells_.count++;
    front_.emplace(0.0, vertex);
  }

  void grow() {
    while (!front_.empty()) {
      const auto [cost, v] = front_.top();
      front_.pop();
      if (cost > cost_[v]) continue;
      for (std::uint32_t i = graph_.neighbours.begin[v]; i < graph_.neighbours.begin[v + 1]; ++i) {
        const std::uint32_t next = graph_.neighbours.others[i];
        const double reached = cost + graph_.costs[i];
        if (!(reached < cost_[next])) continue;
        cost_[next] = reached;
        cells_.cell[next] = cells_.cell[v];
        front_.emplace(reached, next);
      }
    }
  }

  void split_until_good() {
    constexpr int max_rounds = 64;
    for (int round = 0; round < max_rounds; ++round) {
      const Adjacency members = members_of(cells_);
      const std::uint32_t before = cells_.count;
      for (std::uint32_t c = 0; c < before; ++c) {
        if (!within_limits(mesh_, graph_, members.of(c), limits_)) add_seed(farthest(members.of(c)));
      }
      if (cells_.count == before) return;
      grow();
    }
  }

  std::uint32_t farthest(std::span<const std::uint32_t> members) const {
    return *std::max_element(members.begin(), members.end(), [&](auto a, auto b) { return cost_[a] < cost_[b]; });
  }

  void centre_seeds() {
    const Adjacency members = members_of(cells_);
    const std::uint32_t count = std::exchange(cells_.count, 0);
    std::fill(cost_.begin(), cost_.end(), infinite);
    for (std::uint32_t c = 0; c < count; ++c) add_seed(middle_vertex(mesh_, graph_, members.of(c)));
    grow();
  }

  const Mesh& mesh_;
  const VertexGraph& graph_;
  const CellLimits& limits_;
  std::vector<double> cost_;
  Cells cells_;
  Front front_;
};

/// A border between two cells.
struct Border {
  double length = 0;
  std::uint32_t low = 0, high = 0;
};

/// Returns the borders of all cells, longest first.
std::vector<Border> borders_of(const VertexGraph& graph, const Cells& cells) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> lengths;
  for (std::uint32_t v = 0; v < cells.cell.size(); ++v) {
    for (const std::uint32_t next : graph.neighbours.of(v)) {
      if (next < v || cells.cell[next] == cells.cell[v]) continue;
      lengths[std::minmax(cells.cell[v], cells.cell[next])] +=
          std::sqrt(graph.vertex_areas[v] + graph.vertex_areas[next]);
    }
  }
  std::vector<Border> borders;
  for (const auto& [pair, length] : lengths) borders.push_back({length, pair.first, pair.second});
  std::stable_sort(borders.begin(), borders.end(),
                   [](const Border& a, const Border& b) { return a.length > b.length; });
  return borders;
}

/// Merges each cell with at most one neighbour. Returns whether any was merged.
bool merge_once(const Mesh& mesh, const VertexGraph& graph, const CellLimits& limits, Cells& cells) {
  const Adjacency members = members_of(cells);
  std::vector<std::uint32_t> joined(cells.count);  // the cell that each becomes part of
  std::iota(joined.begin(), joined.end(), 0u);
  std::vector<bool> taken(cells.count, false);
  bool any = false;
  for (const Border& border : borders_of(graph, cells)) {
    if (taken[border.low] || taken[border.high]) continue;
    std::vector<std::uint32_t> both(members.of(border.low).begin(), members.of(border.low).end());
    both.insert(both.end(), members.of(border.high).begin(), members.of(border.high).end());
    if (!within_limits(mesh, graph, both, limits)) continue;
    joined[border.high] = border.low;
    taken[border.low] = taken[border.high] = any = true;
  }
  std::vector<std::uint32_t> renumbered(cells.count);
  std::uint32_t count = 0;
  for (std::uint32_t c = 0; c < cells.count; ++c) renumbered[c] = joined[c] == c ? count++ : renumbered[joined[c]];
  for (std::uint32_t& c : cells.cell) c = renumbered[c];
  cells.count = count;
  return any;
}

/// Adds the costs of the cheapest paths from `seed` inside its cell.
void reach_within(const VertexGraph& graph, const Cells& cells, std::uint32_t seed,
                  std::map<std::uint32_t, double>& cost) {
  Front front;
  cost[seed] = 0;
  front.emplace(0.0, seed);
  while (!front.empty()) {
    const auto [so_far, v] = front.top();
    front.pop();
    if (so_far > cost[v]) continue;
    for (std::uint32_t i = graph.neighbours.begin[v]; i < graph.neighbours.begin[v + 1]; ++i) {
      const std::uint32_t next = graph.neighbours.others[i];
      if (cells.cell[next] != cells.cell[seed]) continue;
      const auto [known, is_new] = cost.try_emplace(next, infinite);
      if (!(so_far + graph.costs[i] < known->second)) continue;
      known->second = so_far + graph.costs[i];
      front.emplace(known->second, next);
    }
  }
}

}  // namespace

VertexGraph make_vertex_graph(const Mesh& mesh) {
  VertexGraph graph;
  graph.neighbours = vertex_neighbours(mesh.triangles, mesh.positions.size());
  graph.costs.reserve(graph.neighbours.others.size());
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    for (const std::uint32_t next : graph.neighbours.of(v)) {
      graph.costs.push_back(step_cost(mesh, std::min(v, next), std::max(v, next)));
    }
  }
  graph.vertex_areas.assign(mesh.positions.size(), 0);
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    const double third = glm::length(glm::cross(b - a, c - a)) / 6;
    for (int k = 0; k < 3; ++k) graph.vertex_areas[t[k]] += third;
  }
  return graph;
}

Cells partition(const Mesh& mesh, const VertexGraph& graph, const CellLimits& limits) {
  Cells cells = CellGrower(mesh, graph, limits).partition();
  while (merge_once(mesh, graph, limits, cells)) {
  }
  return cells;
}

Adjacency members_of(const Cells& cells) {
  Adjacency members;
  members.begin.assign(cells.count + 1, 0);
  for (const std::uint32_t c : cells.cell) ++members.begin[c + 1];
  std::partial_sum(members.begin.begin(), members.begin.end(), members.begin.begin());
  members.others.resize(cells.cell.size());
  std::vector<std::uint32_t> next(members.begin.begin(), members.begin.end() - 1);
  for (std::uint32_t v = 0; v < cells.cell.size(); ++v) members.others[next[cells.cell[v]]++] = v;
  return members;
}

void split_cell(const VertexGraph& graph, Cells& cells, std::uint32_t cell) {
  const auto first = std::find(cells.cell.begin(), cells.cell.end(), cell);
  const auto farthest_from = [&](std::uint32_t seed, std::map<std::uint32_t, double>& cost) {
    reach_within(graph, cells, seed, cost);
    return std::max_element(cost.begin(), cost.end(), [](auto& a, auto& b) { return a.second < b.second; })->first;
  };
  std::map<std::uint32_t, double> any, from_one, from_other;
  const std::uint32_t one = farthest_from(static_cast<std::uint32_t>(first - cells.cell.begin()), any);
  const std::uint32_t other = farthest_from(one, from_one);
  if (one == other) return;
  reach_within(graph, cells, other, from_other);
  for (const auto& [v, cost] : from_other) {
    if (v == other || (v != one && cost < from_one[v])) cells.cell[v] = cells.count;
  }
  ++cells.count;
}

std::uint32_t middle_vertex(const Mesh& mesh, const VertexGraph& graph, std::span<const std::uint32_t> members) {
  glm::dvec3 sum(0);
  double area = 0;
  for (const std::uint32_t v : members) {
    sum += graph.vertex_areas[v] * glm::dvec3(mesh.positions[v]);
    area += graph.vertex_areas[v];
  }
  if (!(area > 0)) return members.front();
  const glm::dvec3 middle = sum / area;
  const auto distance = [&](std::uint32_t v) { return glm::distance(glm::dvec3(mesh.positions[v]), middle); };
  return *std::min_element(members.begin(), members.end(), [&](auto a, auto b) { return distance(a) < distance(b); });
}

}  // namespace pelage
