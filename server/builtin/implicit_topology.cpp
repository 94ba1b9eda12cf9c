#include "server/builtin/implicit_topology.h"

#include <algorithm>
#include <cassert>

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
  // The ends may share no neighbour but the two apexes.
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

}  // namespace pelage
