// Makes a simplified mesh of a model, for clients that cast rays themselves.
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
  std::vector<glm::vec3> positions;     // model coordinates minus the centre; each is in a triangle
  std::vector<glm::vec3> normals;       // for each position, unit
  std::vector<std::uint32_t> vertices;  // for each position: its vertex in the full mesh
  std::vector<glm::uvec3> triangles;
};

/// Returns a mesh of at most `triangles` triangles, or of more if the simplifier finds no more edges to collapse, for
/// example where many parts share edges. A mesh with no more triangles is copied. All vertices are vertices of the
/// mesh, with their normals. Parts that are small compared to the requested triangles can vanish. Deterministic; takes
/// 1.3 us for each triangle of the mesh. Refused (invalid) for models smaller than limits::proxy_size.
Result<ProxyMesh> simplify(const Mesh& mesh, std::size_t triangles);

/// The fur at each position: the offsets from a strand's root to its middle and to its tip, in the model's unit, for
/// the coat that is longest there, and the mask, [0, 1].
struct ProxyFur {
  std::vector<glm::vec3> middles, tips;
  std::vector<float> mask;
};
ProxyFur fur_on(const ProxyMesh& proxy, const Mesh& mesh, const FieldSet& fields, const std::vector<NamedCoat>& coats);

/// Returns a binary glTF 2.0 file: one mesh with POSITION, NORMAL and indices (16 bits where they suffice), on one node
/// whose translation is the centre. With fur the mesh has the attributes _FUR_MIDDLE, _FUR_TIP and _MASK as well. The
/// mesh must have a triangle.
std::string glb_of(const ProxyMesh& mesh, const ProxyFur* fur = nullptr);

/// Returns a .npy file with the positions of all vertices, float64 [vertices, 3] in the model's coordinates, in the
/// order in which lists of vertices number them.
std::string npy_of_vertices(const Mesh& mesh);

}  // namespace pelage
