// glTF, GLB and 3DS by assimp, which sees the upload and no other file.
#include <assimp/BaseImporter.h>
#include <assimp/importerdesc.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cstring>
#include <limits>
#include <memory>
#include <string_view>

#include "protocol/base/limits.h"
#include "server/import/import.h"
#include "server/import_worker/assimp_materials.h"
#include "server/import_worker/confine.h"
#include "server/import_worker/gltf_check.h"
#include "server/import_worker/parse.h"

namespace pelage {

namespace {

glm::dmat4 to_matrix(const aiMatrix4x4& m) {
  return glm::transpose(glm::dmat4(m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4,  //
                                   m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4));
}

/// Assimp turns 3DS scenes from Z up to Y up; this undoes it, for the upload itself says where up is.
glm::dmat4 root_matrix(ModelFormat format) {
  if (format != ModelFormat::tds) return glm::dmat4(1);
  return glm::dmat4(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1);
}

/// Leaves only the reader that is asked for, so that assimp guesses nothing. The others become ours to delete.
void keep_only(Assimp::Importer& importer, std::string_view name) {
  for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
    if (importer.GetImporterInfo(i)->mName == name) continue;
    const std::unique_ptr<Assimp::BaseImporter> reader(importer.GetImporter(i));
    importer.UnregisterLoader(reader.get());
  }
}

/// Walks the node tree and collects the polygons of its meshes.
class Collector {
 public:
  Collector(const aiScene& scene, ModelFormat format, RawModel& model)
      : scene_(scene), model_(model), materials_(scene, format, model) {
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
      has_uv_ = has_uv_ || scene.mMeshes[i]->HasTextureCoords(0);
      has_colour_ = has_colour_ || scene.mMeshes[i]->HasVertexColors(0);
    }
  }

  Status walk(const aiNode& node, const glm::dmat4& parent, int depth = 0) {
    constexpr int deepest = 1000;
    if (depth > deepest) return broken("its nodes lie deeper than " + std::to_string(deepest) + " levels.");
    const glm::dmat4 matrix = parent * to_matrix(node.mTransformation);
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      if (node.mMeshes[i] >= scene_.mNumMeshes) return broken("a node names a mesh that is not there.");
      if (Status status = add(*scene_.mMeshes[node.mMeshes[i]], matrix); !status.ok()) return status;
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
      if (Status status = walk(*node.mChildren[i], matrix, depth + 1); !status.ok()) return status;
    }
    return {};
  }

 private:
  Status add(const aiMesh& mesh, const glm::dmat4& node) {
    constexpr std::size_t max_positions = 3 * limits::model_triangles;
    const Result<MaterialReader::Entry> material = materials_.read(mesh.mMaterialIndex);
    if (!material.ok()) return material.status();
    if (model_.positions.size() + mesh.mNumVertices > max_positions ||
        model_.face_sizes.size() + mesh.mNumFaces > max_positions) {
      return broken("it has more vertices or faces than " + std::to_string(limits::model_triangles) +
                    " triangles can have.");
    }
    // A skinned mesh lies where its joints are, whatever its own node says; this is its rest pose.
    const glm::dmat4 matrix = mesh.HasBones() ? glm::dmat4(1) : node;
    const auto first = static_cast<std::uint32_t>(model_.positions.size());
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D& p = mesh.mVertices[v];
      model_.positions.emplace_back(matrix * glm::dvec4(p.x, p.y, p.z, 1));
    }
    const bool mirrored = glm::determinant(glm::dmat3(matrix)) < 0;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices == 0) continue;
      model_.face_sizes.push_back(face.mNumIndices);
      model_.face_material.push_back(material->index);
      for (unsigned k = 0; k < face.mNumIndices; ++k) {
        add_corner(mesh, face.mIndices[mirrored ? face.mNumIndices - 1 - k : k], first, material->uv_channel);
      }
    }
    return {};
  }

  void add_corner(const aiMesh& mesh, unsigned v, std::uint32_t first, unsigned uv_channel) {
    const bool exists = v < mesh.mNumVertices;
    model_.corners.push_back(exists ? first + v : no_position);
    if (has_uv_) {
      const bool has = exists && uv_channel < AI_MAX_NUMBER_OF_TEXTURECOORDS && mesh.HasTextureCoords(uv_channel);
      const aiVector3D uv = has ? mesh.mTextureCoords[uv_channel][v] : aiVector3D();
      model_.corner_uv.push_back(has ? glm::dvec2(uv.x, uv.y) : glm::dvec2(nan));
    }
    if (has_colour_) {
      const aiColor4D c = exists && mesh.HasVertexColors(0) ? mesh.mColors[0][v] : aiColor4D(1, 1, 1, 1);
      model_.corner_colour.emplace_back(c.r, c.g, c.b, c.a);
    }
  }

  const aiScene& scene_;
  RawModel& model_;
  MaterialReader materials_;
  bool has_uv_ = false, has_colour_ = false;
};

/// The first chunk of a 3DS file spans all of it.
Status check_3ds(std::string_view bytes) {
  if (bytes.size() < 6 || !bytes.starts_with("MM")) return broken("it does not begin as a 3DS file does.");
  std::uint32_t size = 0;
  std::memcpy(&size, bytes.data() + 2, sizeof size);
  if (size > bytes.size()) return broken("it is cut off.");
  return {};
}

Status check(ModelFormat format, std::string_view bytes) {
  switch (format) {
    case ModelFormat::glb: return check_glb(bytes);
    case ModelFormat::gltf: return check_gltf(bytes);
    default: return check_3ds(bytes);
  }
}

Status refusal(const Assimp::Importer& importer, const ClosedIo& io) {
  std::string reason = importer.GetErrorString();
  if (!io.refused().empty()) reason = "it needs the other file \"" + io.refused() + "\".";
  return broken(reason.empty() ? "it cannot be read." : reason);
}

}  // namespace

Result<RawModel> parse_with_assimp(ModelFormat format, const std::string& bytes) {
  if (Status status = check(format, bytes); !status.ok()) return status;
  const std::string name = std::string("model.") + worker_format_names[static_cast<std::size_t>(format)];
  auto* io = new ClosedIo(name, bytes);  // the importer deletes it
  Assimp::Importer importer;
  importer.SetIOHandler(io);
  keep_only(importer, format == ModelFormat::tds ? "Discreet 3DS Importer" : "glTF2 Importer");
  const aiScene* scene = importer.ReadFile(name, 0);
  if (!scene || !scene->mRootNode) return refusal(importer, *io);

  RawModel model;
  model.is_32_bit = true;
  Status status = Collector(*scene, format, model).walk(*scene->mRootNode, root_matrix(format));
  if (!status.ok()) return status;
  if (model.corners.empty()) return broken("it has no faces.");
  return model;
}

}  // namespace pelage
