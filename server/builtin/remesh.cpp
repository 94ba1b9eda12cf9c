#include "server/builtin/remesh.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <queue>

#include "base/parallel.h"
#include "server/builtin/implicit.h"

namespace pelage {

HalfEdgeMesh::HalfEdgeMesh(const TriangleMesh& mesh)
    : positions_(mesh.positions), outgoing_(mesh.positions.size(), kNone), live_triangles_(mesh.triangles.size()) {
  origin_.reserve(3 * mesh.triangles.size());
  for (const glm::uvec3& face : mesh.triangles)
    for (int k = 0; k < 3; ++k) origin_.push_back(face[k]);
  for (std::uint32_t h = 0; h < half_edge_count(); ++h) outgoing_[origin_[h]] = h;
  find_twins();
}

void HalfEdgeMesh::find_twins() {
  twin_.assign(origin_.size(), kNone);
  std::vector<std::vector<std::uint32_t>> leaving(positions_.size());
  for (std::uint32_t h = 0; h < half_edge_count(); ++h) leaving[origin_[h]].push_back(h);
  for (std::uint32_t h = 0; h < half_edge_count(); ++h) {
    const auto& candidates = leaving[target(h)];
    const auto found = std::find_if(candidates.begin(), candidates.end(),
                                    [&](std::uint32_t other) { return target(other) == origin_[h]; });
    assert(found != candidates.end());
    twin_[h] = *found;
  }
}

void HalfEdgeMesh::glue(std::uint32_t h, std::uint32_t other) {
  twin_[h] = other;
  twin_[other] = h;
}

int HalfEdgeMesh::valence(std::uint32_t vertex) const {
  int count = 0;
  around(vertex, [&](std::uint32_t) { ++count; });
  return count;
}

std::uint32_t HalfEdgeMesh::split(std::uint32_t h, glm::dvec3 at) {
  const std::uint32_t o = twin_[h], hn = next(h), op = previous(o);
  const std::uint32_t b = target(h), c = apex(h), d = apex(o);
  const std::uint32_t m = vertex_count(), first = half_edge_count();
  const std::uint32_t outer_h = twin_[hn], outer_o = twin_[op];
  positions_.push_back(at);
  // Triangle `first` is (m, b, c), the one after it (b, m, d); the old ones shrink to (a, m, c) and (m, a, d).
  for (const std::uint32_t vertex : {m, b, c, b, m, d}) origin_.push_back(vertex);
  twin_.resize(origin_.size(), kNone);
  origin_[hn] = m;
  origin_[o] = m;
  glue(first, first + 3);
  glue(first + 1, outer_h);
  glue(first + 2, hn);
  glue(first + 4, op);
  glue(first + 5, outer_o);
  outgoing_.push_back(first);
  outgoing_[b] = first + 1;
  live_triangles_ += 2;
  return m;
}

bool HalfEdgeMesh::can_collapse(std::uint32_t h) const {
  const std::uint32_t a = origin(h), b = target(h), c = apex(h), d = apex(twin_[h]);
  if (c == d || valence(c) < 4 || valence(d) < 4) return false;
  // The ends may share no neighbours except the two apexes.
  bool shared = false;
  around(a, [&](std::uint32_t from_a) {
    const std::uint32_t near = target(from_a);
    if (near == b || near == c || near == d) return;
    around(b, [&](std::uint32_t from_b) { shared = shared || target(from_b) == near; });
  });
  return !shared && valence(a) + valence(b) > 6;
}

bool HalfEdgeMesh::folds(std::uint32_t h, glm::dvec3 to) const {
  const std::uint32_t end = target(h);
  bool folded = false;
  around(origin(h), [&](std::uint32_t spoke) {
    const std::uint32_t b = target(spoke), c = apex(spoke);
    if (b == end || c == end) return;
    const glm::dvec3 at_b = positions_[b], at_c = positions_[c];
    const glm::dvec3 before = area_vector(positions_[origin(spoke)], at_b, at_c), after = area_vector(to, at_b, at_c);
    const glm::dvec3 along_b = at_b - to, along_c = at_c - to, along_d = at_c - at_b;
    const double spread = glm::dot(along_b, along_b) + glm::dot(along_c, along_c) + glm::dot(along_d, along_d);
    const double area = glm::length(after);
    folded = folded || area < 0.02 * spread || glm::dot(before, after) < 0.3 * glm::length(before) * area;
  });
  return folded;
}

void HalfEdgeMesh::collapse(std::uint32_t h, glm::dvec3 to) {
  const std::uint32_t o = twin_[h];
  const std::uint32_t a = origin(h), b = target(h), c = apex(h), d = apex(o);
  const std::uint32_t from_c = twin_[next(h)], to_c = twin_[previous(h)];
  const std::uint32_t from_d = twin_[next(o)], to_d = twin_[previous(o)];
  std::uint32_t turning = h;
  do {
    const std::uint32_t following = twin_[previous(turning)];
    origin_[turning] = b;
    turning = following;
  } while (turning != h);
  glue(from_c, to_c);
  glue(from_d, to_d);
  for (const std::uint32_t gone : {h, next(h), previous(h), o, next(o), previous(o)}) origin_[gone] = kNone;
  outgoing_[a] = kNone;
  outgoing_[b] = to_c;
  outgoing_[c] = from_c;
  outgoing_[d] = from_d;
  positions_[b] = to;
  live_triangles_ -= 2;
}

bool HalfEdgeMesh::can_flip(std::uint32_t h) const {
  const std::uint32_t c = apex(h), d = apex(twin_[h]);
  if (c == d || valence(origin(h)) < 4 || valence(target(h)) < 4) return false;
  bool joined = false;
  around(c, [&](std::uint32_t from_c) { joined = joined || target(from_c) == d; });
  return !joined;
}

void HalfEdgeMesh::flip(std::uint32_t h) {
  const std::uint32_t o = twin_[h];
  const std::uint32_t hn = next(h), hp = previous(h), on = next(o), op = previous(o);
  const std::uint32_t a = origin(h), b = target(h), c = apex(h), d = apex(o);
  const std::uint32_t outer_bc = twin_[hn], outer_ca = twin_[hp], outer_ad = twin_[on], outer_db = twin_[op];
  // (a, b, c) and (b, a, d) become (d, c, a) and (c, d, b).
  origin_[h] = d, origin_[hn] = c, origin_[hp] = a;
  origin_[o] = c, origin_[on] = d, origin_[op] = b;
  glue(hn, outer_ca);
  glue(hp, outer_ad);
  glue(on, outer_db);
  glue(op, outer_bc);
  outgoing_[a] = hp;
  outgoing_[b] = op;
  outgoing_[c] = hn;
  outgoing_[d] = on;
}

TriangleMesh HalfEdgeMesh::compact() const {
  TriangleMesh mesh;
  std::vector<std::uint32_t> renamed(positions_.size(), kNone);
  for (std::uint32_t v = 0; v < vertex_count(); ++v) {
    if (!vertex_live(v)) continue;
    renamed[v] = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(positions_[v]);
  }
  mesh.triangles.reserve(live_triangles_);
  for (std::uint32_t h = 0; h < half_edge_count(); h += 3)
    if (live(h)) mesh.triangles.emplace_back(renamed[origin_[h]], renamed[origin_[h + 1]], renamed[origin_[h + 2]]);
  return mesh;
}

// Edge collapse in the order of quadric error (Garland and Heckbert 1997).

namespace {

/// The sum of squared distances to planes, each weighted by its triangle's area.
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
    unsigned changes;  // sum of changes_ of both ends when proposed
    glm::dvec3 to;
    bool operator<(const Candidate& other) const {  // the queue gives the largest first
      return cost != other.cost ? cost > other.cost : half_edge > other.half_edge;
    }
  };

  bool current(const Candidate& c) const {
    return mesh_.live(c.half_edge) && mesh_.origin(c.half_edge) == c.origin && mesh_.target(c.half_edge) == c.target &&
           changes_[c.origin] + changes_[c.target] == c.changes;
  }

  /// Queues the collapse of an edge, to the best of its ends and its middle.
  void propose(std::uint32_t h) {
    const std::uint32_t a = mesh_.origin(h), b = mesh_.target(h);
    Quadric sum = quadrics_[a];
    sum.add(quadrics_[b]);
    const glm::dvec3 at_a = mesh_.position(a), at_b = mesh_.position(b);
    const std::array<glm::dvec3, 3> candidates = {0.5 * (at_a + at_b), at_a, at_b};
    const auto less = [&](glm::dvec3 p, glm::dvec3 q) { return sum.at(p) < sum.at(q); };
    const glm::dvec3 to = *std::min_element(candidates.begin(), candidates.end(), less);
    // A small cost for the length keeps flat parts even.
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

// Isotropic remeshing: split long edges, collapse short ones, even out the valences, relax along the surface.

namespace {

// An edge is split if longer than kLong, and collapsed if shorter than kShort, times the target length.
constexpr double kLong = 4.0 / 3.0;
constexpr double kShort = 4.0 / 5.0;

/// Returns the edge of an equilateral triangle with 1/`count` of the mesh's area.
double edge_for(const TriangleMesh& mesh, int count) {
  double area = 0;
  for (const glm::uvec3& t : mesh.triangles)
    area += glm::length(area_vector(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]));
  return std::sqrt(4 / std::sqrt(3.0) * area / count);
}

class Remesher {
 public:
  Remesher(const ImplicitSurface& surface, const TriangleMesh& mesh) : surface_(surface), mesh_(mesh) {}

  void pass(double edge) {
    split_long(kLong * edge);
    collapse_short(kShort * edge, kLong * edge);
    flip_for_valence();
    relax(edge);
  }

  std::size_t triangles() const { return mesh_.live_triangles(); }
  TriangleMesh result() const { return mesh_.compact(); }

 private:
  glm::dvec3 middle(std::uint32_t h) const {
    return 0.5 * (mesh_.position(mesh_.origin(h)) + mesh_.position(mesh_.target(h)));
  }

  void split_long(double limit) {
    const std::uint32_t count = mesh_.half_edge_count();
    for (std::uint32_t h = 0; h < count; ++h)
      if (mesh_.live(h) && mesh_.twin(h) > h && mesh_.length(h) > limit)
        mesh_.split(h, surface_.project(middle(h), 0.25 * limit));
  }

  void collapse_short(double limit, double longest) {
    for (std::uint32_t h = 0; h < mesh_.half_edge_count(); ++h) {
      if (!mesh_.live(h) || mesh_.twin(h) < h || mesh_.length(h) >= limit || !mesh_.can_collapse(h)) continue;
      const glm::dvec3 to = surface_.project(middle(h), 0.5 * limit);
      if (stays_sound(h, to, longest) && stays_sound(mesh_.twin(h), to, longest)) mesh_.collapse(h, to);
    }
  }

  /// Returns whether the fan around the origin of `h` neither folds nor gets an edge of `longest` or more if the origin
  /// moves to `to`.
  bool stays_sound(std::uint32_t h, glm::dvec3 to, double longest) const {
    bool sound = !mesh_.folds(h, to);
    mesh_.around(mesh_.origin(h), [&](std::uint32_t spoke) {
      const std::uint32_t end = mesh_.target(spoke);
      sound = sound && (end == mesh_.target(h) || glm::distance(to, mesh_.position(end)) < longest);
    });
    return sound;
  }

  void flip_for_valence() {
    for (std::uint32_t h = 0; h < mesh_.half_edge_count(); ++h) {
      if (!mesh_.live(h) || mesh_.twin(h) < h || !flip_evens(h)) continue;
      if (mesh_.can_flip(h) && flip_stays_flat(h)) mesh_.flip(h);
    }
  }

  /// Returns whether a flip brings the four valences closer to six.
  bool flip_evens(std::uint32_t h) const {
    const auto excess = [&](std::uint32_t vertex) { return mesh_.valence(vertex) - 6; };
    const int a = excess(mesh_.origin(h)), b = excess(mesh_.target(h));
    const int c = excess(mesh_.apex(h)), d = excess(mesh_.apex(mesh_.twin(h)));
    const auto sum = [](int p, int q, int r, int s) { return p * p + q * q + r * r + s * s; };
    return sum(a - 1, b - 1, c + 1, d + 1) < sum(a, b, c, d);
  }

  bool flip_stays_flat(std::uint32_t h) const {
    const glm::dvec3 a = mesh_.position(mesh_.origin(h)), b = mesh_.position(mesh_.target(h));
    const glm::dvec3 c = mesh_.position(mesh_.apex(h)), d = mesh_.position(mesh_.apex(mesh_.twin(h)));
    const glm::dvec3 normal = area_vector(a, b, c) + area_vector(b, a, d);
    const double min = 0.1 * glm::length(normal) * glm::length(normal);
    return glm::dot(area_vector(d, c, a), normal) > min && glm::dot(area_vector(c, d, b), normal) > min;
  }

  void relax(double edge) {
    std::vector<glm::dvec3> moved(mesh_.vertex_count());
    for_each_in_parallel(mesh_.vertex_count(), [&](std::uint32_t v) {
      if (mesh_.vertex_live(v)) moved[v] = relaxed(v, edge);
    });
    for (std::uint32_t v = 0; v < mesh_.vertex_count(); ++v)
      if (mesh_.vertex_live(v)) mesh_.move(v, moved[v]);
  }

  /// Returns the vertex moved along the surface towards the mean of its neighbours, weighted so that triangles get
  /// equal areas.
  glm::dvec3 relaxed(std::uint32_t v, double edge) const {
    const glm::dvec3 here = mesh_.position(v);
    glm::dvec3 sum{0}, normal{0};
    double weight = 0;
    mesh_.around(v, [&](std::uint32_t h) {
      const glm::dvec3 b = mesh_.position(mesh_.target(h)), c = mesh_.position(mesh_.apex(h));
      const glm::dvec3 area = area_vector(here, b, c);
      const double size = glm::length(area);
      sum += size / 2 * (b + c);
      weight += size;
      normal += area;
    });
    const double length = glm::length(normal);
    if (length <= 0.2 * weight) return here;
    normal /= length;
    const glm::dvec3 pull = sum / weight - here;
    return surface_.project(here + 0.8 * (pull - glm::dot(pull, normal) * normal), 0.5 * edge);
  }

  const ImplicitSurface& surface_;
  HalfEdgeMesh mesh_;
};

}  // namespace

TriangleMesh remesh(const ImplicitSurface& surface, const TriangleMesh& mesh, int triangles) {
  constexpr int kShaping = 5, kMeasured = 4;
  constexpr double kFinerByPass = 1.5;  // splitting edges several times at once makes slivers
  double edge = edge_for(mesh, triangles);
  Remesher remesher(surface, mesh);
  for (double now = edge_for(mesh, static_cast<int>(mesh.triangles.size())); now > edge; now /= kFinerByPass)
    remesher.pass(now);
  for (int i = 0; i < kShaping; ++i) remesher.pass(edge);
  for (int i = 0; i < kMeasured; ++i) {
    edge *= std::sqrt(static_cast<double>(remesher.triangles()) / triangles);
    remesher.pass(edge);
  }
  return remesher.result();
}

}  // namespace pelage
