// Edge collapse in the order of quadric error (Garland and Heckbert 1997).
#include <algorithm>
#include <array>
#include <queue>

#include "server/builtin/implicit_mesh.h"
#include "server/builtin/implicit_topology.h"

namespace pelage {
namespace {

/// Sum of squared distances to planes, each weighted by its triangle's area.
struct Quadric {
  glm::dmat3 square{0.0};
  glm::dvec3 linear{0};
  double constant = 0;

  void add_plane(glm::dvec3 normal, glm::dvec3 through, double weight) {
    const double offset = -glm::dot(normal, through);
    square += weight * glm::outerProduct(normal, normal);
    linear += weight * offset * normal;
    constant += weight * offset * offset;
  }
  void add(const Quadric& other) {
    square += other.square;
    linear += other.linear;
    constant += other.constant;
  }
  double at(glm::dvec3 p) const { return glm::dot(p, square * p) + 2 * glm::dot(linear, p) + constant; }
};

class Decimator {
 public:
  explicit Decimator(const TriangleMesh& mesh) : mesh_(mesh), quadrics_(mesh.positions.size()) {
    for (const glm::uvec3& t : mesh.triangles) {
      const glm::dvec3 area = area_vector(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]);
      const double size = glm::length(area);
      for (int k = 0; k < 3 && size > 0; ++k) quadrics_[t[k]].add_plane(area / size, mesh.positions[t[k]], size);
    }
    changes_.assign(mesh.positions.size(), 0);
    for (std::uint32_t h = 0; h < mesh_.half_edge_count(); ++h)
      if (h < mesh_.twin(h)) propose(h);
  }

  TriangleMesh run(std::size_t triangles) {
    while (mesh_.live_triangles() > triangles && !queue_.empty()) {
      const Candidate best = queue_.top();
      queue_.pop();
      if (current(best) && mesh_.can_collapse(best.half_edge) && !mesh_.folds(best.half_edge, best.to) &&
          !mesh_.folds(mesh_.twin(best.half_edge), best.to))
        apply(best);
    }
    return mesh_.compact();
  }

 private:
  struct Candidate {
    double cost;
    std::uint32_t half_edge, origin, target;
    unsigned changes;  // of both ends when proposed
    glm::dvec3 to;
    bool operator<(const Candidate& other) const {  // the queue gives the largest first
      return cost != other.cost ? cost > other.cost : half_edge > other.half_edge;
    }
  };

  bool current(const Candidate& c) const {
    return mesh_.live(c.half_edge) && mesh_.origin(c.half_edge) == c.origin && mesh_.target(c.half_edge) == c.target &&
           changes_[c.origin] + changes_[c.target] == c.changes;
  }

  /// The ends may meet at either one or half way.
  void propose(std::uint32_t h) {
    const std::uint32_t a = mesh_.origin(h), b = mesh_.target(h);
    Quadric sum = quadrics_[a];
    sum.add(quadrics_[b]);
    const glm::dvec3 at_a = mesh_.position(a), at_b = mesh_.position(b);
    const std::array<glm::dvec3, 3> places = {0.5 * (at_a + at_b), at_a, at_b};
    const auto less = [&](glm::dvec3 p, glm::dvec3 q) { return sum.at(p) < sum.at(q); };
    const glm::dvec3 to = *std::min_element(places.begin(), places.end(), less);
    // A little of the length too, which keeps flat parts even.
    const double length = mesh_.length(h);
    queue_.push({sum.at(to) + 5e-3 * length * length * length * length, h, a, b, changes_[a] + changes_[b], to});
  }

  void apply(const Candidate& best) {
    mesh_.collapse(best.half_edge, best.to);
    quadrics_[best.target].add(quadrics_[best.origin]);
    ++changes_[best.target];
    mesh_.around(best.target, [&](std::uint32_t h) { propose(h); });
  }

  HalfEdgeMesh mesh_;
  std::vector<Quadric> quadrics_;  // of each vertex
  std::vector<unsigned> changes_;  // of each vertex: how often it has moved
  std::priority_queue<Candidate> queue_;
};

}  // namespace

TriangleMesh decimate(const TriangleMesh& mesh, int triangles) {
  return Decimator(mesh).run(static_cast<std::size_t>(std::max(triangles, 4)));
}

}  // namespace pelage
