#include "server/import_worker/pose.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace pelage {

namespace {

glm::dvec3 to_vector(const aiVector3D& v) { return {v.x, v.y, v.z}; }

/// Returns the positions with morph targets applied. Assimp's targets hold positions, not differences.
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

/// The sums of weighted matrices and of weights for each vertex.
struct Blend {
  std::vector<glm::dmat4> matrices;
  std::vector<double> weights;
};

Blend blend_of(const aiMesh& mesh, const NodeTransforms& transforms) {
  Blend blend{std::vector<glm::dmat4>(mesh.mNumVertices, glm::dmat4(0)), std::vector<double>(mesh.mNumVertices, 0)};
  for (unsigned b = 0; b < mesh.mNumBones; ++b) {
    const aiBone& bone = *mesh.mBones[b];
    const glm::dmat4* joint = transforms.of(bone.mName.C_Str());
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

bool mirrors(const glm::dmat4& matrix) { return glm::determinant(glm::dmat3(matrix)) < 0; }

/// Returns the mesh with no face turned yet.
PosedMesh unposed(const aiMesh& mesh) {
  PosedMesh posed{shaped(mesh), std::vector<bool>(mesh.mNumFaces, false),
                  std::vector<std::uint32_t>(mesh.mNumVertices)};
  std::iota(posed.apart.begin(), posed.apart.end(), 0u);
  return posed;
}

std::span<const unsigned> corners_of(const aiFace& face) { return {face.mIndices, face.mNumIndices}; }

/// Gives turned faces positions of their own (see pose).
void set_apart(const aiMesh& mesh, PosedMesh& posed) {
  std::vector<bool> is_shared(mesh.mNumVertices, false), is_apart(is_shared);
  const auto each_vertex = [&](bool turned, const auto& visit) {
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      if (posed.turned[f] != turned) continue;
      for (const unsigned v : corners_of(mesh.mFaces[f]))
        if (v < mesh.mNumVertices) visit(v);
    }
  };
  each_vertex(false, [&](unsigned v) { is_shared[v] = true; });
  each_vertex(true, [&](unsigned v) {
    if (is_apart[v]) return;
    is_apart[v] = true;
    if (is_shared[v]) posed.apart[v] = static_cast<std::uint32_t>(posed.positions.size());
    if (is_shared[v]) posed.positions.push_back(glm::dvec3(posed.positions[v]));
    double& x = posed.positions[posed.apart[v]].x;
    x = std::nextafter(x, std::numeric_limits<double>::infinity());
  });
}

PosedMesh skinned(const aiMesh& mesh, const NodeTransforms& transforms) {
  PosedMesh posed = unposed(mesh);
  const Blend blend = blend_of(mesh, transforms);
  std::vector<bool> mirrored(mesh.mNumVertices, false);
  for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
    if (!(blend.weights[v] > 0)) continue;
    const glm::dmat4 matrix = blend.matrices[v] / blend.weights[v];
    posed.positions[v] = glm::dvec3(matrix * glm::dvec4(posed.positions[v], 1));
    mirrored[v] = mirrors(matrix);
  }
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const auto corners = corners_of(mesh.mFaces[f]);
    const auto turned =
        std::count_if(corners.begin(), corners.end(), [&](unsigned v) { return v < mirrored.size() && mirrored[v]; });
    posed.turned[f] = 2 * turned > static_cast<std::ptrdiff_t>(corners.size());
  }
  set_apart(mesh, posed);
  return posed;
}

}  // namespace

glm::dmat4 to_matrix(const aiMatrix4x4& m) {
  return glm::transpose(glm::dmat4(m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4,  //
                                   m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4));
}

NodeTransforms::NodeTransforms(const aiScene& scene, const glm::dmat4& root) {
  std::vector<std::pair<const aiNode*, glm::dmat4>> waiting{{scene.mRootNode, root}};
  while (!waiting.empty()) {
    const auto [node, parent] = waiting.back();
    waiting.pop_back();
    const glm::dmat4 transform = parent * to_matrix(node->mTransformation);
    transforms_.emplace(node->mName.C_Str(), transform);
    for (unsigned i = 0; i < node->mNumChildren; ++i) waiting.emplace_back(node->mChildren[i], transform);
  }
}

const glm::dmat4* NodeTransforms::of(const std::string& name) const {
  const auto found = transforms_.find(name);
  return found == transforms_.end() ? nullptr : &found->second;
}

PosedMesh pose(const aiMesh& mesh, const glm::dmat4& node, const NodeTransforms& transforms) {
  if (mesh.HasBones()) return skinned(mesh, transforms);
  PosedMesh posed = unposed(mesh);
  posed.turned.assign(mesh.mNumFaces, mirrors(node));
  for (glm::dvec3& position : posed.positions) position = glm::dvec3(node * glm::dvec4(position, 1));
  return posed;
}

std::vector<std::string> mirroring_joints(const aiMesh& mesh, const NodeTransforms& transforms) {
  std::vector<std::string> names;
  for (unsigned b = 0; b < mesh.mNumBones; ++b) {
    const aiBone& bone = *mesh.mBones[b];
    const glm::dmat4* joint = transforms.of(bone.mName.C_Str());
    if (joint && bone.mNumWeights > 0 && mirrors(*joint * to_matrix(bone.mOffsetMatrix)))
      names.push_back(bone.mName.C_Str());
  }
  return names;
}

}  // namespace pelage
