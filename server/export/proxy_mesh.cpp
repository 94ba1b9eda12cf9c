#include "server/export/proxy_mesh.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <utility>

#include "base/limits.h"
#include "renderer/image/npy.h"
#include "server/export/glb_writer.h"
#include "server/groom/standing_fur.h"

namespace pelage {

namespace {

/// The mesh with equal positions merged. Vertices that differ in the file can coincide in 32 bits, and the simplifier
/// would take them for the two sides of a seam.
struct Welded {
  std::vector<glm::vec3> positions;     // internal, all different
  std::vector<std::uint32_t> vertices;  // for each position: one of its vertices in the mesh
  std::vector<glm::uvec3> triangles;    // indices of positions, three different ones each
};

Welded weld_positions(const Mesh& mesh) {
  std::vector<std::uint32_t> remap(mesh.positions.size());
  Welded welded;
  welded.positions.resize(meshopt_generateVertexRemap(remap.data(), &mesh.triangles.front().x,
                                                      3 * mesh.triangles.size(), mesh.positions.data(),
                                                      mesh.positions.size(), sizeof(glm::vec3)));
  welded.vertices.resize(welded.positions.size());
  welded.triangles.reserve(mesh.triangles.size());
  for (const glm::uvec3 triangle : mesh.triangles) {
    glm::uvec3 corners;
    for (int k = 0; k < 3; ++k) {
      corners[k] = remap[triangle[k]];
      welded.positions[corners[k]] = mesh.positions[triangle[k]];
      welded.vertices[corners[k]] = triangle[k];
    }
    if (corners.x != corners.y && corners.y != corners.z && corners.z != corners.x) welded.triangles.push_back(corners);
  }
  return welded;
}

std::vector<glm::uvec3> with_vertices_of_mesh(std::vector<glm::uvec3> triangles, const Welded& welded) {
  for (glm::uvec3& triangle : triangles) {
    for (int k = 0; k < 3; ++k) triangle[k] = welded.vertices[triangle[k]];
  }
  return triangles;
}

/// Returns about `triangles` triangles, as indices of vertices of the mesh; empty if the whole model would vanish.
std::vector<glm::uvec3> fewer_triangles(const Mesh& mesh, std::size_t triangles) {
  constexpr float any_error = 1;  // relative to the model's box: only the number of triangles is a limit
  const Welded welded = weld_positions(mesh);
  std::vector<glm::uvec3> fewer = welded.triangles;
  if (fewer.size() > triangles) {  // required by the simplifier
    fewer.resize(meshopt_simplify(&fewer.front().x, &welded.triangles.front().x, 3 * welded.triangles.size(),
                                  &welded.positions.front().x, welded.positions.size(), sizeof(glm::vec3),
                                  3 * triangles, any_error, 0, nullptr) /
                 3);
  }
  return with_vertices_of_mesh(std::move(fewer), welded);
}

/// Renumbers the vertices of the triangles in order of their first use, and copies them.
void copy_used(const Mesh& mesh, ProxyMesh& proxy) {
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> numbers(mesh.positions.size(), unused);
  for (glm::uvec3& triangle : proxy.triangles) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = triangle[k];
      if (numbers[vertex] == unused) {
        numbers[vertex] = static_cast<std::uint32_t>(proxy.positions.size());
        proxy.positions.emplace_back(glm::dvec3(mesh.positions[vertex]) * mesh.size);
        proxy.normals.push_back(mesh.normals[vertex]);
        proxy.vertices.push_back(vertex);
      }
      triangle[k] = numbers[vertex];
    }
  }
}

}  // namespace

Result<ProxyMesh> simplify(const Mesh& mesh, std::size_t triangles) {
  if (mesh.size < limits::proxy_size) {
    return failure(Code::invalid, "The model is too small for a mesh with 32-bit coordinates.", "",
                   "a size of at least 1e-30");
  }
  ProxyMesh proxy;
  proxy.centre = mesh.centre;
  if (mesh.triangles.size() > triangles) proxy.triangles = fewer_triangles(mesh, triangles);
  if (proxy.triangles.empty()) proxy.triangles = mesh.triangles;
  copy_used(mesh, proxy);
  return proxy;
}

namespace {

/// A coat that is not muted, and its fields.
struct StandingCoat {
  FieldSet fields;
  const Coat& coat;

  double length_at(std::uint32_t vertex) const {
    return fields.number(Field::density, vertex) > 0 ? fields.number(Field::length, vertex) : 0;
  }
};

}  // namespace

ProxyFur fur_on(const ProxyMesh& proxy, const Mesh& mesh, const FieldSet& fields, const std::vector<NamedCoat>& coats) {
  constexpr std::size_t middle = UnitStrand::sample_count / 2 - 1, tip = UnitStrand::sample_count - 1;
  std::vector<StandingCoat> standing;
  for (const NamedCoat& coat : coats)
    if (!coat.muted) standing.push_back({fields.of_coat(coat.id), coat.coat});
  ProxyFur fur;
  const std::span<const float> mask = fields.values(Field::mask);
  for (const std::uint32_t vertex : proxy.vertices) {
    const StandingCoat& longest =
        *std::ranges::max_element(standing, {}, [&](const StandingCoat& coat) { return coat.length_at(vertex); });
    const UnitStrand strand = strand_at(vertex, mesh, longest.fields, longest.coat);
    const double length = mesh.size * longest.length_at(vertex);
    fur.middles.emplace_back(length * strand.offsets[middle]);
    fur.tips.emplace_back(length * strand.offsets[tip]);
    fur.mask.push_back(mask.empty() ? 1 : mask[vertex]);
  }
  return fur;
}

std::string glb_of(const ProxyMesh& mesh, const ProxyFur* fur) {
  GlbWriter file;
  GltfJson attributes;
  attributes["POSITION"] = file.add_positions(mesh.positions);
  attributes["NORMAL"] = file.add(std::span(mesh.normals));
  const int triangles = file.add_triangles(mesh.triangles, mesh.positions.size());
  if (fur != nullptr) {
    attributes["_FUR_MIDDLE"] = file.add(std::span(fur->middles));
    attributes["_FUR_TIP"] = file.add(std::span(fur->tips));
    attributes["_MASK"] = file.add(std::span(fur->mask));
  }
  const GltfJson skin = {{"attributes", attributes}, {"indices", triangles}};
  file.set_scene(node_of("skin", 0, mesh.centre), GltfJson::array({skin}));
  return std::move(file.finish()).value();  // limits::proxy_triangles take only some megabytes
}

std::string npy_of_vertices(const Mesh& mesh) {
  std::vector<double> numbers;
  numbers.reserve(3 * mesh.positions.size());
  for (const glm::vec3& position : mesh.positions) {
    const glm::dvec3 in_model = mesh.to_model(position);
    numbers.insert(numbers.end(), {in_model.x, in_model.y, in_model.z});
  }
  return encode_npy(std::array{mesh.positions.size(), std::size_t{3}}, std::span<const double>(numbers));
}

}  // namespace pelage
