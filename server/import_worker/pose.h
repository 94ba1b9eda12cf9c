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

/// Matrices of all nodes of a scene, from the node to the scene.
class NodePlaces {
 public:
  /// `root` comes before the transform of the root node.
  NodePlaces(const aiScene& scene, const glm::dmat4& root);
  /// Null for a name that no node has.
  const glm::dmat4* of(const std::string& name) const;

 private:
  std::unordered_map<std::string, glm::dmat4> places_;
};

struct PosedMesh {
  std::vector<glm::dvec3> positions;  // of the scene
  std::vector<bool> turned;           // of each face: whether it is wound the other way
  std::vector<std::uint32_t> apart;   // of each vertex, the position that turned faces have it at
};

/// A skinned mesh lies where its joints are, whatever its own node says (glTF 2.0, 3.7.3): each vertex is the sum over
/// its joints of weight x place of the joint x inverse bind matrix. Weights count over their sum; without any, and
/// where joints are not there, a vertex stays where it was bound. Faces most of whose corners joints mirror are turned,
/// and set apart from the others by the least that a number can say, so that the two are not taken for one surface that
/// is wound both ways. Any other mesh lies where `node` puts it.
PosedMesh pose(const aiMesh& mesh, const glm::dmat4& node, const NodePlaces& places);

/// Names of the mesh's joints that turn what hangs on them inside out.
std::vector<std::string> mirroring_joints(const aiMesh& mesh, const NodePlaces& places);

}  // namespace pelage
