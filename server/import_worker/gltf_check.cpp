#include "server/import_worker/gltf_check.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <set>
#include <vector>

#include "server/import_worker/gltf_json.h"
#include "server/import_worker/parse.h"

namespace pelage {

namespace {

using gltf::index;
using gltf::item;
using gltf::json;
using gltf::list;
using gltf::member;
using gltf::printable;
using gltf::text;

std::uint32_t number_at(std::string_view bytes, std::size_t offset) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + offset, sizeof number);  // little-endian, as this machine
  return number;
}

Status check_version(const json& root) {
  const auto asset = root.find("asset");
  const std::string version = asset == root.end() ? "" : text(*asset, "version");
  if (version.starts_with("2.") || version == "2") return {};
  return broken("its glTF version is \"" + printable(version) + "\"; only 2.0 is read.");
}

/// Returns the reason for refusing a required extension.
std::string reason_of_extension(const std::string& name) {
  const auto compressed = [&](const char* by) {
    return std::string("its mesh is compressed with ") + by + " (" + name + "); export it without compression.";
  };
  if (name == "KHR_draco_mesh_compression") return compressed("Draco");
  if (name == "EXT_meshopt_compression" || name == "KHR_meshopt_compression") return compressed("meshopt");
  return "it requires the extension " + printable(name) + ", which is not read; export it without.";
}

/// Returns whether the extension is read (gltf_plain.h), is named among the missing pictures, or changes neither shape
/// nor base colour.
bool is_known_extension(const std::string& name) {
  constexpr std::array known{"KHR_mesh_quantization",   "KHR_texture_transform",
                             "EXT_mesh_gpu_instancing", "KHR_texture_basisu",
                             "EXT_texture_webp",        "EXT_texture_avif",
                             "MSFT_texture_dds",        "KHR_lights_punctual",
                             "EXT_lights_image_based",  "KHR_xmp",
                             "KHR_xmp_json_ld",         "MSFT_lod"};
  return name.starts_with("KHR_materials_") || std::find(known.begin(), known.end(), name) != known.end();
}

Status check_extensions(const json& root) {
  for (const json& entry : list(root, "extensionsRequired")) {
    const std::string name = entry.is_string() ? entry.get<std::string>() : "?";
    if (!is_known_extension(name)) return broken(reason_of_extension(name));
  }
  return {};
}

/// Counts the extensions that the file does not require, but without which it looks different.
void count_extensions(const json& root, RawModel& model) {
  for (const json& entry : list(root, "extensionsUsed")) {
    const std::string name = entry.is_string() ? entry.get<std::string>() : "?";
    if (!is_known_extension(name)) model.add_loss("ignored_extensions", printable(name));
  }
}

Status check_scenes(const json& root) {
  return list(root, "scenes").empty() ? broken("it has no scene, so that nothing of it is shown; export a scene.")
                                      : Status();
}

bool is_outside(const std::string& uri) { return !uri.empty() && !uri.starts_with("data:"); }

/// Returns whether a data URI is base64 and has nothing else after its comma.
bool is_base64(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos || !uri.substr(0, comma).ends_with(";base64")) return false;
  std::string_view data = uri.substr(comma + 1);
  while (data.ends_with('=')) data.remove_suffix(1);
  const auto is_digit = [](unsigned char c) { return std::isalnum(c) != 0 || c == '+' || c == '/'; };
  return data.size() % 4 != 1 && std::all_of(data.begin(), data.end(), is_digit);
}

/// Refuses missing or broken buffers; count_pictures counts missing pictures.
Status check_uris(const json& root, const Bundle& bundle) {
  const json& buffers = list(root, "buffers");
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    const std::string uri = text(buffers[i], "uri");
    if (is_outside(uri) && !bundle.find(uri)) {
      return broken("it needs the other file \"" + printable(uri) +
                    "\"; pack it as a GLB, or load a zip archive of both.");
    }
    if (uri.starts_with("data:") && !is_base64(uri))
      return broken("the base64 of its buffer " + std::to_string(i) + " is broken; export it again.");
  }
  return {};
}

Status check_buffers(const json& root, std::size_t binary_bytes) {
  const json& buffers = list(root, "buffers");
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    if (!text(buffers[i], "uri").empty()) continue;
    const std::int64_t size = index(buffers[i], "byteLength");
    if (i > 0 || size < 0 || static_cast<std::uint64_t>(size) > binary_bytes) {
      return broken("buffer " + std::to_string(i) + " has no data, or less than its byteLength.");
    }
  }
  return {};
}

/// Checks that every node has at most one parent, and that the nodes have no cycle.
Status check_nodes(const json& root) {
  const json& nodes = list(root, "nodes");
  std::vector<std::int64_t> parent(nodes.size(), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const json& child : list(nodes[i], "children")) {
      const std::int64_t c = child.is_number_unsigned() ? child.get<std::int64_t>() : -1;
      const bool exists = c >= 0 && c < static_cast<std::int64_t>(nodes.size());
      if (!exists) return broken("a node names a child that is not there.");
      if (parent[static_cast<std::size_t>(c)] >= 0) return broken("node " + std::to_string(c) + " has two parents.");
      parent[static_cast<std::size_t>(c)] = static_cast<std::int64_t>(i);
    }
  }
  // As each node has at most one parent, nodes that cannot be reached from a root lie on a cycle or below one.
  std::vector<std::size_t> reached;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (parent[i] < 0) reached.push_back(i);
  }
  for (std::size_t i = 0; i < reached.size(); ++i) {
    for (const json& child : list(nodes[reached[i]], "children")) reached.push_back(child.get<std::size_t>());
  }
  return reached.size() == nodes.size() ? Status() : broken("its node graph has a cycle.");
}

Status check_attributes(const json& root) {
  for (const json& mesh : list(root, "meshes")) {
    for (const json& primitive : list(mesh, "primitives")) {
      const json& attributes = member(primitive, "attributes");
      for (const char* name : {"POSITION", "TEXCOORD_0"}) {
        const std::int64_t accessor = index(attributes, name);
        if (accessor >= 0 && !item(list(root, "accessors"), accessor))
          return broken(std::string("an accessor of ") + name + " is missing.");
      }
    }
  }
  return {};
}

/// Counts base-colour textures without a PNG or JPEG, whose picture only an extension names.
void count_textures(const json& root, RawModel& model) {
  std::set<std::int64_t> textures;
  for (const json& material : list(root, "materials"))
    textures.insert(index(member(member(material, "pbrMetallicRoughness"), "baseColorTexture"), "index"));
  for (const std::int64_t number : textures) {
    const json* texture = item(list(root, "textures"), number);
    if (!texture || item(list(root, "images"), index(*texture, "source"))) continue;
    std::string name = "texture " + std::to_string(number);
    for (const auto& [extension, source] : member(*texture, "extensions").items())
      name = gltf::name_of(list(root, "images"), index(source, "source"), "image") + ", " + printable(extension);
    model.add_loss("missing_pictures", name);
  }
}

void count_pictures(const json& root, const Bundle& bundle, RawModel& model) {
  const json& images = list(root, "images");
  for (std::size_t i = 0; i < images.size(); ++i) {
    const std::string uri = text(images[i], "uri");
    if (is_outside(uri) && !bundle.find(uri)) model.add_loss("missing_pictures", printable(uri));
    if (uri.starts_with("data:") && !is_base64(uri))
      model.add_loss("broken_pictures", gltf::name_of(images, static_cast<std::int64_t>(i), "image"));
  }
}

void count_primitives(const json& mesh, RawModel& model) {
  constexpr std::int64_t first_of_triangles = 4;
  for (const json& primitive : list(mesh, "primitives")) {
    const std::int64_t mode = index(primitive, "mode");
    const bool has_positions =
        primitive.is_object() && primitive.contains("attributes") && index(primitive["attributes"], "POSITION") >= 0;
    if (!has_positions) model.add_loss("primitives_without_vertices", printable(text(mesh, "name")));
    if (has_positions && mode >= 0 && mode < first_of_triangles)
      model.add_loss("points_and_lines", printable(text(mesh, "name")));
  }
}

void count_losses(const json& root, const Bundle& bundle, RawModel& model) {
  count_extensions(root, model);
  count_pictures(root, bundle, model);
  count_textures(root, model);
  for (const json& mesh : list(root, "meshes")) count_primitives(mesh, model);
}

struct Chunk {
  std::uint32_t type = 0;
  std::string_view data;
};

/// Removes the next chunk from `bytes`. Returns false if it is cut off.
bool take_chunk(std::string_view& bytes, Chunk& chunk) {
  constexpr std::size_t header = 8;
  if (bytes.size() < header) return false;
  const std::uint32_t size = number_at(bytes, 0);
  chunk.type = number_at(bytes, 4);
  bytes.remove_prefix(header);
  if (size > bytes.size()) return false;
  chunk.data = bytes.substr(0, size);
  bytes.remove_prefix(size);
  return true;
}

}  // namespace

Status check_glb(std::string_view bytes, const Bundle& bundle, RawModel& model) {
  constexpr std::size_t header = 12;
  constexpr std::uint32_t json_type = 0x4e4f534a, binary_type = 0x004e4942;
  if (bytes.size() < header || !bytes.starts_with("glTF")) return broken("it does not begin with the GLB magic.");
  if (number_at(bytes, 4) != 2) return broken("its GLB version is not 2.");
  if (number_at(bytes, 8) != bytes.size()) {
    return broken("its header says " + std::to_string(number_at(bytes, 8)) + " bytes, but it has " +
                  std::to_string(bytes.size()) + "; it is cut off or broken.");
  }
  bytes.remove_prefix(header);
  Chunk document, binary;
  if (!take_chunk(bytes, document)) return broken("its first chunk is cut off.");
  if (document.type != json_type) return broken("its first chunk is not JSON.");
  for (Chunk chunk; !bytes.empty();) {
    if (!take_chunk(bytes, chunk)) return broken("a chunk is cut off.");
    if (chunk.type == binary_type && binary.data.empty()) binary = chunk;
  }
  return check_gltf(document.data, bundle, model, binary.data.size());
}

Status check_gltf(std::string_view document, const Bundle& bundle, RawModel& model, std::size_t binary_bytes) {
  const Result<json> root = parse_json(document);
  if (!root.ok()) return broken("its JSON is broken: " + printable(root.status().message));
  if (!root->is_object()) return broken("its JSON is no object.");
  for (const Status& status :
       {check_version(*root), check_extensions(*root), check_uris(*root, bundle), check_buffers(*root, binary_bytes),
        check_nodes(*root), check_scenes(*root), check_attributes(*root)}) {
    if (!status.ok()) return status;
  }
  count_losses(*root, bundle, model);
  return {};
}

}  // namespace pelage
