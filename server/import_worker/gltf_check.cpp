#include "server/import_worker/gltf_check.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <vector>

#include "protocol/json/parse.h"
#include "server/import_worker/parse.h"

namespace pelage {

namespace {

using nlohmann::json;

std::uint32_t number_at(std::string_view bytes, std::size_t place) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + place, sizeof number);  // little-endian, as this machine
  return number;
}

/// The member when it is an array, else an empty one.
const json& list(const json& object, const char* name) {
  static const json none = json::array();
  if (!object.is_object()) return none;
  const auto member = object.find(name);
  return member != object.end() && member->is_array() ? *member : none;
}

std::string text(const json& object, const char* name) {
  if (!object.is_object()) return {};
  const auto member = object.find(name);
  return member != object.end() && member->is_string() ? member->get<std::string>() : std::string();
}

/// The member as an index, -1 when it is none.
std::int64_t index(const json& object, const char* name) {
  if (!object.is_object()) return -1;
  const auto member = object.find(name);
  return member != object.end() && member->is_number_unsigned() ? member->get<std::int64_t>() : -1;
}

std::string printable(std::string word) {
  word.resize(std::min<std::size_t>(word.size(), 200));
  std::replace_if(
      word.begin(), word.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  return word;
}

Status check_version(const json& root) {
  const auto asset = root.find("asset");
  const std::string version = asset == root.end() ? "" : text(*asset, "version");
  if (version.starts_with("2.") || version == "2") return {};
  return broken("its glTF version is \"" + printable(version) + "\"; only 2.0 is read.");
}

/// What a required extension does to the mesh.
std::string reason_of_extension(const std::string& name) {
  const auto compressed = [&](const char* by) {
    return std::string("its mesh is compressed with ") + by + " (" + name + "); export it without compression.";
  };
  if (name == "KHR_draco_mesh_compression") return compressed("Draco");
  if (name == "EXT_meshopt_compression" || name == "KHR_meshopt_compression") return compressed("meshopt");
  if (name == "KHR_mesh_quantization") return "its mesh is quantized (" + name + "); export it with 32-bit numbers.";
  return "it requires the extension " + printable(name) + ", which is not read; export it without.";
}

Status check_extensions(const json& root) {
  for (const json& entry : list(root, "extensionsRequired")) {
    const std::string name = entry.is_string() ? entry.get<std::string>() : "?";
    const bool look_only = name.starts_with("KHR_materials_") || name == "KHR_lights_punctual";
    if (!look_only) return broken(reason_of_extension(name));
  }
  return {};
}

Status check_scenes(const json& root) {
  return list(root, "scenes").empty() ? broken("it has no scene, so that nothing of it is shown; export a scene.")
                                      : Status();
}

bool is_outside(const std::string& uri) { return !uri.empty() && !uri.starts_with("data:"); }

/// Whether all of what a data URI has after its comma is base64.
bool is_base64(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos || !uri.substr(0, comma).ends_with(";base64")) return false;
  std::string_view data = uri.substr(comma + 1);
  while (data.ends_with('=')) data.remove_suffix(1);
  const auto is_digit = [](unsigned char c) { return std::isalnum(c) != 0 || c == '+' || c == '/'; };
  return data.size() % 4 != 1 && std::all_of(data.begin(), data.end(), is_digit);
}

/// Buffers have to be there; pictures that are not are counted by count_pictures.
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

/// Every node has one parent at most, and none is below itself.
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
  // With one parent each, the nodes that no walk from a root reaches lie on a cycle.
  std::vector<std::size_t> reached;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (parent[i] < 0) reached.push_back(i);
  }
  for (std::size_t i = 0; i < reached.size(); ++i) {
    for (const json& child : list(nodes[reached[i]], "children")) reached.push_back(child.get<std::size_t>());
  }
  return reached.size() == nodes.size() ? Status() : broken("its node graph has a cycle.");
}

/// Assimp copies the bytes of other types as if they were floats.
Status check_attribute_types(const json& root) {
  constexpr std::int64_t float_type = 5126;
  const json& accessors = list(root, "accessors");
  for (const json& mesh : list(root, "meshes")) {
    for (const json& primitive : list(mesh, "primitives")) {
      const auto attributes = primitive.is_object() ? primitive.find("attributes") : primitive.end();
      if (attributes == primitive.end()) continue;
      for (const char* name : {"POSITION", "TEXCOORD_0"}) {
        const std::int64_t accessor = index(*attributes, name);
        if (accessor < 0) continue;
        if (accessor >= static_cast<std::int64_t>(accessors.size()) ||
            index(accessors[static_cast<std::size_t>(accessor)], "componentType") != float_type) {
          return broken(std::string("an accessor of ") + name + " is missing or holds no 32-bit floats.");
        }
      }
    }
  }
  return {};
}

void count_pictures(const json& root, const Bundle& bundle, RawModel& model) {
  const json& images = list(root, "images");
  for (std::size_t i = 0; i < images.size(); ++i) {
    const std::string uri = text(images[i], "uri"), name = text(images[i], "name");
    if (is_outside(uri) && !bundle.find(uri)) model.lose("missing_pictures", printable(uri));
    if (uri.starts_with("data:") && !is_base64(uri))
      model.lose("broken_pictures", name.empty() ? "image " + std::to_string(i) : printable(name));
  }
}

void count_primitives(const json& mesh, RawModel& model) {
  constexpr std::int64_t first_of_triangles = 4;
  for (const json& primitive : list(mesh, "primitives")) {
    const std::int64_t mode = index(primitive, "mode");
    const bool has_positions =
        primitive.is_object() && primitive.contains("attributes") && index(primitive["attributes"], "POSITION") >= 0;
    if (!has_positions) model.lose("primitives_without_vertices", printable(text(mesh, "name")));
    if (has_positions && mode >= 0 && mode < first_of_triangles)
      model.lose("points_and_lines", printable(text(mesh, "name")));
  }
}

void count_losses(const json& root, const Bundle& bundle, RawModel& model) {
  count_pictures(root, bundle, model);
  for (const json& mesh : list(root, "meshes")) count_primitives(mesh, model);
}

struct Chunk {
  std::uint32_t type = 0;
  std::string_view data;
};

/// Takes the next chunk off `bytes`; false when it is cut off.
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
        check_nodes(*root), check_scenes(*root), check_attribute_types(*root)}) {
    if (!status.ok()) return status;
  }
  count_losses(*root, bundle, model);
  return {};
}

}  // namespace pelage
