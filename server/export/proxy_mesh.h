// A light stand-in for a model, for clients that cast rays themselves.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "base/status.h"
#include "protocol/commands/coat.h"
#include "server/fields/field_set.h"
#include "server/surface/mesh.h"

namespace pelage {

/// Triangles in the model's unit, relative to the model's centre so that 32 bits suffice far from the origin.
struct ProxyMesh {
  glm::dvec3 centre{0};                 // model coordinates
  std::vector<glm::vec3> positions;     // model coordinates minus the centre; each is used
  std::vector<glm::vec3> normals;       // of each position, unit
  std::vector<std::uint32_t> vertices;  // of each position: the vertex of the mesh that it is
  std::vector<glm::uvec3> triangles;
};

/// Returns a mesh of at most `triangles` triangles, or of more where the simplifier finds no more edges to collapse, as
/// where many parts share edges. A mesh that has no more is taken as it is. Vertices of the answer are vertices of the
/// mesh, with their normals; parts that are small next to the triangles asked for can vanish. Deterministic; 1.3 us for
/// a triangle of the mesh. Refused (invalid) below limits::proxy_size.
Result<ProxyMesh> simplify(const Mesh& mesh, std::size_t triangles);

/// Where the strand on each position stands: from the root to half of its length and to its tip, in the model's unit;
/// and the mask there.
struct ProxyFur {
  std::vector<glm::vec3> middles, tips;
  std::vector<float> mask;
};
ProxyFur fur_on(const ProxyMesh& proxy, const Mesh& mesh, const FieldSet& fields, const std::vector<NamedCoat>& coats);

/// A binary glTF 2.0 file: one mesh with POSITION, NORMAL and indices (16 bits where they suffice), on one node whose
/// translation is the centre. With fur the mesh has the attributes _FUR_MIDDLE, _FUR_TIP and _MASK as well. There
/// is a triangle at least.
std::string glb_of(const ProxyMesh& mesh, const ProxyFur* fur = nullptr);

/// A .npy file of the places of all vertices, [vertices, 3] in the model's coordinates, in the order of lists of
/// vertices.
std::string npy_of_vertices(const Mesh& mesh);

}  // namespace pelage
