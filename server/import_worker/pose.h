// Positions of a mesh's vertices: morph targets at their weights, then the transform of the joints or of the node.
#pragma once

#include <assimp/scene.h>

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <unordered_map>
#include <vector>

namespace pelage {

glm::dmat4 to_matrix(const aiMatrix4x4& m);

/// The matrices of all nodes of a scene, from node space to scene space.
class NodeTransforms {
 public:
  /// `root` is the parent matrix of the root node.
  NodeTransforms(const aiScene& scene, const glm::dmat4& root);
  /// Returns the matrix of a node; null if no node has that name.
  const glm::dmat4* of(const std::string& name) const;

 private:
  std::unordered_map<std::string, glm::dmat4> transforms_;
};

struct PosedMesh {
  std::vector<glm::dvec3> positions;  // in scene space
  std::vector<bool> turned;           // for each face: true if its winding is reversed
  std::vector<std::uint32_t> apart;   // for each vertex: index of its position in faces that are turned
};

/// Returns the mesh in scene space. A mesh without joints is transformed by `node`. A skinned mesh follows its joints
/// and ignores its own node (glTF 2.0, 3.7.3): each vertex is the sum over its joints of weight x joint matrix x
/// inverse bind matrix, with normalized weights. A vertex without weights, or without existing joints, stays in its
/// bind position. Faces with most corners mirrored by joints are turned. Their vertices are moved from those of other
/// faces by the smallest floating-point step, so that the two are not welded to one surface with inconsistent winding.
PosedMesh pose(const aiMesh& mesh, const glm::dmat4& node, const NodeTransforms& transforms);

/// Returns the names of the mesh's joints whose transforms mirror, and so turn the surface inside out.
std::vector<std::string> mirroring_joints(const aiMesh& mesh, const NodeTransforms& transforms);

}  // namespace pelage
