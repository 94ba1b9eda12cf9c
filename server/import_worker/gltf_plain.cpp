#include "server/import_worker/gltf_plain.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "server/import_worker/gltf_json.h"
#include "server/import_worker/gltf_numbers.h"
#include "server/import_worker/parse.h"

namespace pelage {

namespace {

using gltf::index;
using gltf::item;
using gltf::json;
using gltf::list;
using gltf::member;

constexpr std::uint64_t float_type = 5126;  // unsigned, as the JSON library compares types, too

bool is_float_attribute(const std::string& name) {
  return name == "POSITION" || name.starts_with("TEXCOORD_") || name.starts_with("WEIGHTS_");
}

double number(const json& object, const char* name, double fallback) {
  const auto found = object.find(name);
  return found != object.end() && found->is_number() ? found->get<double>() : fallback;
}

/// Returns an item of a list of numbers; `fallback` if it is missing.
double number_at(const json& numbers, std::size_t i, double fallback) {
  return i < numbers.size() && numbers[i].is_number() ? numbers[i].get<double>() : fallback;
}

/// Applies KHR_texture_transform to texture coordinates (v down): scale, then rotation, then offset.
std::vector<double> transformed(const std::vector<double>& uvs, const json& transform) {
  const json &offset = list(transform, "offset"), &scale = list(transform, "scale");
  const double turn = number(transform, "rotation", 0), c = std::cos(turn), s = std::sin(turn);
  std::vector<double> moved;
  for (std::size_t i = 0; i + 1 < uvs.size(); i += 2) {
    const double u = uvs[i] * number_at(scale, 0, 1), v = uvs[i + 1] * number_at(scale, 1, 1);
    moved.push_back(number_at(offset, 0, 0) + c * u + s * v);
    moved.push_back(number_at(offset, 1, 0) - s * u + c * v);
  }
  return moved;
}

/// Calls `visit` for each item of an array of the object, until one fails.
template <class Visit>
Status each(json& object, const char* name, const Visit& visit) {
  if (list(object, name).empty()) return {};
  for (json& entry : object[name])
    if (Status status = visit(entry); !status.ok()) return status;
  return {};
}

/// Replaces the base colour, which is for programs that do not know the extension, by the extension's diffuse colour.
Status use_diffuse(json& material) {
  const json diffuse = member(member(material, "extensions"), "KHR_materials_pbrSpecularGlossiness");
  if (diffuse.empty()) return {};
  json plain = json::object();
  if (diffuse.contains("diffuseFactor")) plain["baseColorFactor"] = diffuse["diffuseFactor"];
  if (diffuse.contains("diffuseTexture")) plain["baseColorTexture"] = diffuse["diffuseTexture"];
  material["pbrMetallicRoughness"] = std::move(plain);
  material["extensions"].erase("KHR_materials_pbrSpecularGlossiness");
  return {};
}

/// Counts the triangles with an index that no vertex has. `mode` is the glTF topology: strip, fan, else a list.
std::size_t count_bad_faces(const std::vector<double>& indices, std::int64_t mode, double vertices) {
  constexpr std::int64_t strip = 5, fan = 6;
  const std::size_t step = mode == strip || mode == fan ? 1 : 3;
  const auto is_bad = [&](std::size_t i) { return indices[i] >= vertices; };
  std::size_t bad = 0;
  for (std::size_t i = 0; i + 2 < indices.size(); i += step)
    bad += is_bad(mode == fan ? 0 : i) || is_bad(i + 1) || is_bad(i + 2) ? 1 : 0;
  return bad;
}

/// Rewrites a document in plain glTF, as PlainGltf describes.
class Plain {
 public:
  Plain(json& root, const Bundle& bundle, std::string_view binary) : root_(root), numbers_(root, bundle, binary) {}

  Status say_all() {
    const auto primitives = [&](json& mesh) {
      return each(mesh, "primitives", [&](json& primitive) { return say(primitive); });
    };
    const auto samplers = [&](json& animation) {
      return each(animation, "samplers", [&](json& sampler) { return to_floats(sampler, "output"); });
    };
    for (Status status : {each(root_, "materials", use_diffuse), each(root_, "meshes", primitives),
                          each(root_, "animations", samplers), say_instances()}) {
      if (!status.ok()) return status;
    }
    for (const auto& [material, channel] : moved_) forget_transform(material, channel);
    if (!floats_.empty())
      root_["buffers"].push_back(
          {{"byteLength", floats_.size()}, {"uri", "data:application/octet-stream;base64," + to_base64(floats_)}});
    return {};
  }

  std::size_t bad_faces() const { return bad_faces_; }

 private:
  Status say(json& primitive) {
    if (member(primitive, "attributes").empty()) return {};
    json& attributes = primitive["attributes"];
    const json* positions = item(list(root_, "accessors"), index(attributes, "POSITION"));
    if (const auto indices = numbers_.of(index(primitive, "indices")); positions && indices)
      bad_faces_ +=
          count_bad_faces(*indices, index(primitive, "mode"), static_cast<double>(index(*positions, "count")));
    if (Status status = move_texture(index(primitive, "material"), attributes); !status.ok()) return status;
    std::vector<std::string> names;
    for (const auto& [name, accessor] : attributes.items()) names.push_back(name);
    for (const std::string& name : names)
      if (Status status = is_float_attribute(name) ? to_floats(attributes, name) : Status(); !status.ok())
        return status;
    return each(primitive, "targets", [&](json& target) { return to_floats(target, "POSITION"); });
  }

  static Status beyond(std::int64_t accessor) {
    return broken("its accessor " + std::to_string(accessor) + " is sparse, or reaches beyond its buffer.");
  }

  /// Replaces the accessor that `name` names by one of floats, if it has other numbers.
  Status to_floats(json& object, const std::string& name) {
    const std::int64_t accessor = index(object, name.c_str());
    const json* entry = item(list(root_, "accessors"), accessor);
    if (!entry || index(*entry, "componentType") == static_cast<std::int64_t>(float_type)) return {};
    if (const auto known = as_floats_.find(accessor); known != as_floats_.end())
      return object[name] = known->second, Status();
    const auto numbers = numbers_.of(accessor);
    if (!numbers) return beyond(accessor);
    object[name] = as_floats_[accessor] = added(*numbers, std::string(gltf::text(*entry, "type")));
    return {};
  }

  /// Adds an accessor with these numbers as floats, and returns its index.
  std::size_t added(const std::vector<double>& numbers, const std::string& type) {
    const std::size_t width = type == "SCALAR" ? 1 : static_cast<std::size_t>(type.back() - '0');
    const std::size_t begin = floats_.size();
    for (const double number : numbers) {
      const auto value = static_cast<float>(number);
      floats_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    json& views = root_["bufferViews"];
    json& accessors = root_["accessors"];
    accessors.push_back({{"bufferView", views.size()},
                         {"componentType", float_type},
                         {"count", numbers.size() / width},
                         {"type", type}});
    views.push_back(
        {{"buffer", list(root_, "buffers").size()}, {"byteOffset", begin}, {"byteLength", floats_.size() - begin}});
    return accessors.size() - 1;
  }

  Status move_texture(std::int64_t number, json& attributes) {
    const json* material = item(list(root_, "materials"), number);
    if (!material) return {};
    const json& texture = member(member(*material, "pbrMetallicRoughness"), "baseColorTexture");
    const json& transform = member(member(texture, "extensions"), "KHR_texture_transform");
    if (transform.empty()) return {};
    const std::int64_t own = index(transform, "texCoord");
    const std::int64_t channel = std::max<std::int64_t>(own >= 0 ? own : index(texture, "texCoord"), 0);
    const std::string name = "TEXCOORD_" + std::to_string(channel);
    moved_[number] = channel;
    const std::int64_t accessor = index(attributes, name.c_str());
    if (accessor < 0) return {};
    const auto uvs = numbers_.of(accessor);
    if (!uvs) return beyond(accessor);
    attributes[name] = added(transformed(*uvs, transform), "VEC2");
    return {};
  }

  void forget_transform(std::int64_t material, std::int64_t channel) {
    json& texture = root_["materials"][static_cast<std::size_t>(material)]["pbrMetallicRoughness"]["baseColorTexture"];
    texture["texCoord"] = static_cast<std::uint64_t>(channel);
    texture["extensions"].erase("KHR_texture_transform");
  }

  /// Replaces the instances of a node's mesh by child nodes.
  Status say_instances() {
    const std::size_t nodes = list(root_, "nodes").size();
    for (std::size_t i = 0; i < nodes; ++i) {
      json node = root_["nodes"][i];
      const json instances = member(member(member(node, "extensions"), "EXT_mesh_gpu_instancing"), "attributes");
      if (instances.empty() || !node.contains("mesh")) continue;
      Result<std::vector<json>> children = instances_of(node["mesh"], instances);
      if (!children) return children.status();
      for (json& child : *children) {
        node["children"].push_back(root_["nodes"].size());
        root_["nodes"].push_back(std::move(child));
      }
      node.erase("mesh");
      root_["nodes"][i] = std::move(node);
    }
    return {};
  }

  Result<std::vector<json>> instances_of(const json& mesh, const json& attributes) {
    constexpr std::size_t most = 100'000;
    std::vector<json> nodes;
    for (const auto& [name, member, width] :
         {std::tuple("TRANSLATION", "translation", 3u), {"ROTATION", "rotation", 4u}, {"SCALE", "scale", 3u}}) {
      const std::int64_t accessor = index(attributes, name);
      if (accessor < 0) continue;
      const auto numbers = numbers_.of(accessor);
      if (!numbers) return beyond(accessor);
      const std::size_t count = numbers->size() / width;
      if (count > most) return broken("a node has more than " + std::to_string(most) + " instances of its mesh.");
      if (nodes.size() < count) nodes.resize(count, json{{"mesh", mesh}});
      for (std::size_t i = 0; i < count; ++i)
        nodes[i][member] = std::vector<double>(numbers->begin() + static_cast<std::ptrdiff_t>(i * width),
                                               numbers->begin() + static_cast<std::ptrdiff_t>((i + 1) * width));
    }
    return nodes;
  }

  json& root_;
  GltfNumbers numbers_;
  std::string floats_;                             // content of the new buffer
  std::map<std::int64_t, std::size_t> as_floats_;  // new accessors, by the ones that they replace
  std::map<std::int64_t, std::int64_t> moved_;     // UV channels of materials with transformed coordinates
  std::size_t bad_faces_ = 0;
};

std::string four_bytes(std::size_t number) {
  const auto value = static_cast<std::uint32_t>(number);
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);  // little-endian, as this machine
  return bytes;
}

/// Returns the node's mesh if the node has weights of its own, else null.
const json* weighted_mesh(const json& node, const json& meshes) {
  if (!node.is_object() || !node.contains("weights") || !node["weights"].is_array()) return nullptr;
  const auto index = node.find("mesh");
  const bool exists = index != node.end() && index->is_number_unsigned() && index->get<std::size_t>() < meshes.size();
  return exists && meshes[index->get<std::size_t>()].is_object() ? &meshes[index->get<std::size_t>()] : nullptr;
}

/// Moves the weights of nodes, which override those of their meshes (glTF 2.0, 3.7.2.2), to the meshes: each such node
/// gets a copy of its mesh. check_gltf has accepted the document.
void move_weights(json& root) {
  if (list(root, "nodes").empty() || list(root, "meshes").empty()) return;
  json& meshes = root["meshes"];
  for (json& node : root["nodes"]) {
    const json* mesh = weighted_mesh(node, meshes);
    if (!mesh) continue;
    json copy = *mesh;
    copy["weights"] = node["weights"];
    node["mesh"] = meshes.size();
    meshes.push_back(std::move(copy));
  }
}

}  // namespace

Result<PlainGltf> plain_gltf(std::string document, const Bundle& bundle, std::string_view binary) {
  Result<json> root = parse_json(document);
  if (!root) return root.status();
  const json before = *root;
  move_weights(*root);
  Plain plain(*root, bundle, binary);
  if (Status status = plain.say_all(); !status.ok()) return status;
  return PlainGltf{*root == before ? std::move(document) : root->dump(), plain.bad_faces()};
}

Result<PlainGltf> plain_glb(std::string bytes, const Bundle& bundle) {
  constexpr std::size_t header = 12, chunk_header = 8;
  std::uint32_t size = 0;
  std::memcpy(&size, bytes.data() + header, sizeof size);
  const std::string_view rest = std::string_view(bytes).substr(header + chunk_header + size);
  const std::string_view binary = rest.substr(std::min(rest.size(), chunk_header));
  const std::string document = bytes.substr(header + chunk_header, size);
  Result<PlainGltf> plain = plain_gltf(document, bundle, binary);
  if (!plain) return plain;
  std::string& changed = plain->bytes;
  if (changed == document) return PlainGltf{std::move(bytes), plain->bad_faces};
  changed.resize((changed.size() + 3) / 4 * 4, ' ');
  const std::string chunks = four_bytes(changed.size()) + "JSON" + changed + std::string(rest);
  return PlainGltf{bytes.substr(0, 8) + four_bytes(header + chunks.size()) + chunks, plain->bad_faces};
}

}  // namespace pelage
