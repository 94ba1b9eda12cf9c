#include "server/import_worker/pose.h"

#include <cmath>
#include <utility>

namespace pelage {

namespace {

glm::dvec3 to_vector(const aiVector3D& v) { return {v.x, v.y, v.z}; }

/// With the morph targets, which hold places and not differences.
std::vector<glm::dvec3> shaped(const aiMesh& mesh) {
  std::vector<glm::dvec3> positions;
  for (unsigned v = 0; v < mesh.mNumVertices; ++v) positions.push_back(to_vector(mesh.mVertices[v]));
  for (unsigned target = 0; target < mesh.mNumAnimMeshes; ++target) {
    const aiAnimMesh& shape = *mesh.mAnimMeshes[target];
    const double weight = double{shape.mWeight};
    if (!shape.HasPositions() || shape.mNumVertices != mesh.mNumVertices || !std::isfinite(weight)) continue;
    for (unsigned v = 0; v < mesh.mNumVertices; ++v)
      positions[v] += weight * (to_vector(shape.mVertices[v]) - to_vector(mesh.mVertices[v]));
  }
  return positions;
}

/// Sums of weighted matrices, and of weights, for each vertex.
struct Blend {
  std::vector<glm::dmat4> matrices;
  std::vector<double> weights;
};

Blend blend_of(const aiMesh& mesh, const NodePlaces& places) {
  Blend blend{std::vector<glm::dmat4>(mesh.mNumVertices, glm::dmat4(0)), std::vector<double>(mesh.mNumVertices, 0)};
  for (unsigned b = 0; b < mesh.mNumBones; ++b) {
    const aiBone& bone = *mesh.mBones[b];
    const glm::dmat4* joint = places.of(bone.mName.C_Str());
    if (!joint) continue;
    const glm::dmat4 matrix = *joint * to_matrix(bone.mOffsetMatrix);
    for (unsigned i = 0; i < bone.mNumWeights; ++i) {
      const aiVertexWeight& entry = bone.mWeights[i];
      const double weight = double{entry.mWeight};
      if (entry.mVertexId >= mesh.mNumVertices || !(weight > 0) || !std::isfinite(weight)) continue;
      blend.matrices[entry.mVertexId] += weight * matrix;
      blend.weights[entry.mVertexId] += weight;
    }
  }
  return blend;
}

PosedMesh skinned(const aiMesh& mesh, const NodePlaces& places) {
  PosedMesh posed{shaped(mesh), false};
  const Blend blend = blend_of(mesh, places);
  std::size_t turned = 0, moved = 0;
  for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
    if (!(blend.weights[v] > 0)) continue;
    const glm::dmat4 matrix = blend.matrices[v] / blend.weights[v];
    posed.positions[v] = glm::dvec3(matrix * glm::dvec4(posed.positions[v], 1));
    ++moved;
    if (glm::determinant(glm::dmat3(matrix)) < 0) ++turned;
  }
  posed.mirrored = 2 * turned > moved;
  return posed;
}

}  // namespace

glm::dmat4 to_matrix(const aiMatrix4x4& m) {
  return glm::transpose(glm::dmat4(m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4,  //
                                   m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4));
}

NodePlaces::NodePlaces(const aiScene& scene, const glm::dmat4& root) {
  std::vector<std::pair<const aiNode*, glm::dmat4>> waiting{{scene.mRootNode, root}};
  while (!waiting.empty()) {
    const auto [node, parent] = waiting.back();
    waiting.pop_back();
    const glm::dmat4 place = parent * to_matrix(node->mTransformation);
    places_.emplace(node->mName.C_Str(), place);
    for (unsigned i = 0; i < node->mNumChildren; ++i) waiting.emplace_back(node->mChildren[i], place);
  }
}

const glm::dmat4* NodePlaces::of(const std::string& name) const {
  const auto found = places_.find(name);
  return found == places_.end() ? nullptr : &found->second;
}

PosedMesh pose(const aiMesh& mesh, const glm::dmat4& node, const NodePlaces& places) {
  if (mesh.HasBones()) return skinned(mesh, places);
  PosedMesh posed{shaped(mesh), glm::determinant(glm::dmat3(node)) < 0};
  for (glm::dvec3& position : posed.positions) position = glm::dvec3(node * glm::dvec4(position, 1));
  return posed;
}

}  // namespace pelage
