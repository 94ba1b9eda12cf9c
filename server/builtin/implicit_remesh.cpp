// Isotropic remeshing: split long edges, collapse short ones, even the valences out, relax along the surface.
#include <cmath>

#include "server/builtin/implicit_mesh.h"
#include "server/builtin/implicit_topology.h"

namespace pelage {
namespace {

// Above and below these shares of the wished-for length an edge is split or merged.
constexpr double kLong = 4.0 / 3.0;
constexpr double kShort = 4.0 / 5.0;

/// Edge of an equilateral triangle when `count` of them make up the mesh's area.
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

  /// Whether the fan around the origin of `h` neither folds nor gets too long an edge when its hub moves to `to`.
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

  /// Whether a flip brings the four valences nearer to six.
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
    const double least = 0.1 * glm::length(normal) * glm::length(normal);
    return glm::dot(area_vector(d, c, a), normal) > least && glm::dot(area_vector(c, d, b), normal) > least;
  }

  void relax(double edge) {
    std::vector<glm::dvec3> moved(mesh_.vertex_count());
    for (std::uint32_t v = 0; v < mesh_.vertex_count(); ++v)
      if (mesh_.vertex_live(v)) moved[v] = relaxed(v, edge);
    for (std::uint32_t v = 0; v < mesh_.vertex_count(); ++v)
      if (mesh_.vertex_live(v)) mesh_.move(v, moved[v]);
  }

  /// Towards the mean of the neighbours, along the surface, weighted so that triangles get equal areas.
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
