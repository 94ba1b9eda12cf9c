#include "server/import_worker/parse_assimp.h"

#include <assimp/BaseImporter.h>
#include <assimp/importerdesc.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cstring>
#include <limits>
#include <memory>
#include <set>
#include <string_view>

#include "base/limits.h"
#include "server/import/import.h"
#include "server/import_worker/animation.h"
#include "server/import_worker/confine.h"
#include "server/import_worker/gltf_check.h"
#include "server/import_worker/gltf_json.h"
#include "server/import_worker/gltf_plain.h"
#include "server/import_worker/parse.h"
#include "server/import_worker/pose.h"
#include "server/import_worker/read_picture.h"
#include "server/import_worker/skeleton.h"

namespace pelage {

namespace {

struct Texture {
  aiString path;
  unsigned uv_channel = 0;
};

bool find_texture(const aiMaterial& material, Texture& texture) {
  for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
    if (material.GetTexture(type, 0, &texture.path, nullptr, &texture.uv_channel) == aiReturn_SUCCESS) return true;
  }
  return false;
}

/// Returns the name of a material; "" for a name that assimp made up.
std::string name_of(const aiMaterial& material) {
  aiString name;
  material.Get(AI_MATKEY_NAME, name);
  const std::string_view text = name.C_Str();
  const bool made_up = text.starts_with("%%%") || text == AI_DEFAULT_MATERIAL_NAME;
  return made_up ? std::string() : gltf::printable(std::string(text));
}

/// Returns the linear base colour. Factors of glTF are linear, colours of 3DS are sRGB.
glm::vec3 base_colour(const aiMaterial& material, ModelFormat format) {
  aiColor4D colour(1, 1, 1, 1);
  if (format == ModelFormat::tds) {
    aiString name;
    material.Get(AI_MATKEY_NAME, name);
    const bool is_default = std::string_view(name.C_Str()).starts_with("%%%DEFAULT");  // assimp's own grey
    if (is_default || material.Get(AI_MATKEY_COLOR_DIFFUSE, colour) != aiReturn_SUCCESS) return glm::vec3(1);
    return srgb_to_linear({colour.r, colour.g, colour.b});
  }
  if (material.Get(AI_MATKEY_BASE_COLOR, colour) != aiReturn_SUCCESS) material.Get(AI_MATKEY_COLOR_DIFFUSE, colour);
  return {colour.r, colour.g, colour.b};
}

}  // namespace

Result<MaterialReader::Entry> MaterialReader::read(unsigned index) {
  if (const auto known = materials_.find(index); known != materials_.end()) return known->second;
  if (model_.materials.size() > std::numeric_limits<std::uint16_t>::max()) return broken("it has too many materials.");
  Entry entry{static_cast<std::uint16_t>(model_.materials.size()), 0};
  RawMaterial material;
  if (index < scene_.mNumMaterials) {
    const aiMaterial& source = *scene_.mMaterials[index];
    Texture texture;
    material.base_colour = base_colour(source, format_);
    material.name = name_of(source);
    if (find_texture(source, texture)) {
      material.image = read_image(texture.path.C_Str());
      entry.uv_channel = texture.uv_channel;
    }
  }
  model_.materials.push_back(material);
  return materials_.emplace(index, entry).first->second;
}

std::optional<std::string_view> MaterialReader::bytes_of(const char* path) const {
  const aiTexture* texture = scene_.GetEmbeddedTexture(path);
  if (!texture) {
    const std::string* bundled = bundle_.find(path);
    return bundled ? std::optional<std::string_view>(*bundled) : std::nullopt;
  }
  if (texture->mHeight != 0) return std::string_view();  // raw texels, which no format here has
  return std::string_view(reinterpret_cast<const char*>(texture->pcData), texture->mWidth);
}

int MaterialReader::read_image(const std::string& path) {
  if (!bundle_.with_pictures()) return -1;
  if (const auto known = images_.find(path); known != images_.end()) return known->second;
  int index = -1;
  if (const auto bytes = bytes_of(path.c_str())) {
    index = add_picture(model_, *bytes, path);
  } else if (format_ == ModelFormat::tds) {  // gltf_check has counted those of glTF
    model_.add_loss("missing_pictures", path);
  }
  return images_.emplace(path, index).first->second;
}

// glTF, GLB and 3DS by assimp, which sees the upload and no other file.

namespace {

/// Undoes assimp's rotation of 3DS scenes from Z up to Y up; RawModel::up says which axis is up.
glm::dmat4 root_matrix(ModelFormat format) {
  if (format != ModelFormat::tds) return glm::dmat4(1);
  return glm::dmat4(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1);
}

/// Unregisters all readers except the named one, so that assimp does not guess a format. Unregistered readers belong to
/// the caller, who has to delete them.
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
  Collector(const aiScene& scene, ModelFormat format, const Bundle& bundle, RawModel& model)
      : scene_(scene),
        model_(model),
        materials_(scene, format, bundle, model),
        node_transforms_(scene, root_matrix(format)) {
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
      has_uv_ = has_uv_ || scene.mMeshes[i]->HasTextureCoords(0);
      has_colour_ = has_colour_ || scene.mMeshes[i]->HasVertexColors(0);
    }
  }

  const NodeTransforms& node_transforms() const { return node_transforms_; }

  /// Adds invalid faces for those that assimp dropped, so that they are counted, and reports joints that mirror.
  void finish(std::size_t bad_faces) {
    for (std::size_t i = 0; i < bad_faces && !model_.materials.empty(); ++i) {
      model_.face_sizes.push_back(3);
      model_.face_material.push_back(0);
      model_.corners.insert(model_.corners.end(), 3, no_position);
      for (int k = 0; k < 3; ++k) add_look(aiMesh(), 0, 0);
    }
    for (const std::string& joint : mirroring_) model_.add_loss("mirrored_joints", gltf::printable(joint));
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
    const auto first = static_cast<std::uint32_t>(model_.positions.size());
    const PosedMesh posed = pose(mesh, node, node_transforms_);
    model_.positions.insert(model_.positions.end(), posed.positions.begin(), posed.positions.end());
    for (const std::string& joint : mirroring_joints(mesh, node_transforms_)) mirroring_.insert(joint);
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices < 3) continue;  // points and lines
      model_.face_sizes.push_back(face.mNumIndices);
      model_.face_material.push_back(material->index);
      for (unsigned k = 0; k < face.mNumIndices; ++k) {
        const unsigned v = face.mIndices[posed.turned[f] ? face.mNumIndices - 1 - k : k];
        const bool exists = v < mesh.mNumVertices;
        model_.corners.push_back(exists ? first + (posed.turned[f] ? posed.apart[v] : v) : no_position);
        add_look(mesh, v, material->uv_channel);
      }
    }
    return {};
  }

  void add_look(const aiMesh& mesh, unsigned v, unsigned uv_channel) {
    const bool exists = v < mesh.mNumVertices;
    if (has_uv_) {
      const bool has = exists && uv_channel < AI_MAX_NUMBER_OF_TEXTURECOORDS && mesh.HasTextureCoords(uv_channel);
      const aiVector3D uv = has ? mesh.mTextureCoords[uv_channel][v] : aiVector3D();
      model_.corner_uv.push_back(has ? given_uv(uv.x, uv.y) : glm::dvec2(nan));
    }
    if (has_colour_) {
      const aiColor4D c = exists && mesh.HasVertexColors(0) ? mesh.mColors[0][v] : aiColor4D(1, 1, 1, 1);
      model_.corner_colour.emplace_back(c.r, c.g, c.b, c.a);
    }
  }

  const aiScene& scene_;
  RawModel& model_;
  MaterialReader materials_;
  NodeTransforms node_transforms_;
  std::set<std::string> mirroring_;  // names of joints
  bool has_uv_ = false, has_colour_ = false;
};

/// Checks the size of a 3DS file: its first chunk spans the whole file.
Status check_3ds(std::string_view bytes) {
  if (bytes.size() < 6 || !bytes.starts_with("MM")) return broken("it does not begin as a 3DS file does.");
  std::uint32_t size = 0;
  std::memcpy(&size, bytes.data() + 2, sizeof size);
  if (size > bytes.size()) return broken("it is cut off.");
  return {};
}

Status check(ModelFormat format, Bundle& bundle, RawModel& model) {
  switch (format) {
    case ModelFormat::glb: return check_glb(bundle.model(), bundle, model);
    case ModelFormat::gltf: return check_gltf(bundle.model(), bundle, model);
    default: return check_3ds(bundle.model());
  }
}

/// Rewrites glTF in plain form. Returns the number of faces that assimp will drop.
Result<std::size_t> say_plainly(ModelFormat format, Bundle& bundle) {
  if (format == ModelFormat::tds) return std::size_t{0};
  std::string& bytes = bundle.model();
  Result<PlainGltf> plain = format == ModelFormat::glb ? plain_glb(bytes, bundle) : plain_gltf(bytes, bundle);
  if (!plain) return plain.status();
  bytes = std::move(plain->bytes);
  return plain->bad_faces;
}

Status refusal(const Assimp::Importer& importer, const ClosedIo& io, const RawModel& model) {
  for (const Repair& loss : model.losses) {
    if (loss.code != "primitives_without_vertices") continue;
    return broken("a primitive of its mesh \"" + (loss.names.empty() ? "" : loss.names.front()) +
                  "\" has no vertices; export it again.");
  }
  std::string reason = importer.GetErrorString();
  if (!io.refused().empty()) reason = "it needs the other file \"" + io.refused() + "\".";
  return broken(reason.empty() ? "it cannot be read." : reason);
}

}  // namespace

Result<RawModel> parse_with_assimp(ModelFormat format, Bundle& bundle, const std::string& pose) {
  RawModel model;
  model.is_32_bit = true;
  if (Status status = check(format, bundle, model); !status.ok()) return status;
  const Result<std::size_t> bad_faces = say_plainly(format, bundle);
  if (!bad_faces) return bad_faces.status();
  const std::string name = std::string("model.") + worker_format_names[static_cast<std::size_t>(format)];
  auto* io = new ClosedIo(name, bundle.model(), bundle);  // the importer deletes it
  Assimp::Importer importer;
  importer.SetIOHandler(io);
  keep_only(importer, format == ModelFormat::tds ? "Discreet 3DS Importer" : "glTF2 Importer");
  const aiScene* read = importer.ReadFile(name, 0);
  if (!read || !read->mRootNode) return refusal(importer, *io, model);
  const std::unique_ptr<aiScene> scene(importer.GetOrphanedScene());
  model.animations = animation_names(*scene);
  if (Status posed = pose.empty() ? Status{} : apply_pose(*scene, pose); !posed.ok()) return posed;

  Collector collector(*scene, format, bundle, model);
  Status status = collector.walk(*scene->mRootNode, root_matrix(format));
  if (!status.ok()) return status;
  if (model.corners.empty())
    return broken(model.losses.empty() ? "it has no faces." : "it has no faces, but points or lines.");
  collector.finish(*bad_faces);
  model.front = front_by_joints(*scene, collector.node_transforms(), Axis::plus_y);
  return model;
}

}  // namespace pelage
