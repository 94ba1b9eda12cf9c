#include "server/import_worker/gltf_weights.h"

#include <cstdint>
#include <cstring>

#include "protocol/json/parse.h"

namespace pelage {

namespace {

using nlohmann::json;

/// The node's mesh where the node gives weights of its own, else none.
const json* weighted_mesh(const json& node, const json& meshes) {
  if (!node.is_object() || !node.contains("weights") || !node["weights"].is_array()) return nullptr;
  const auto index = node.find("mesh");
  const bool exists = index != node.end() && index->is_number_unsigned() && index->get<std::size_t>() < meshes.size();
  return exists && meshes[index->get<std::size_t>()].is_object() ? &meshes[index->get<std::size_t>()] : nullptr;
}

/// Whether a node had weights.
bool move_weights(json& root) {
  if (!root.contains("nodes") || !root.contains("meshes") || !root["nodes"].is_array() || !root["meshes"].is_array())
    return false;
  bool moved = false;
  json& meshes = root["meshes"];
  for (json& node : root["nodes"]) {
    const json* mesh = weighted_mesh(node, meshes);
    if (!mesh) continue;
    json copy = *mesh;
    copy["weights"] = node["weights"];
    node["mesh"] = meshes.size();
    meshes.push_back(std::move(copy));
    moved = true;
  }
  return moved;
}

std::string four_bytes(std::size_t number) {
  const auto value = static_cast<std::uint32_t>(number);
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);  // little-endian, as this machine
  return bytes;
}

}  // namespace

std::string with_node_weights(std::string document) {
  Result<json> root = parse_json(document);
  if (!root || !move_weights(*root)) return document;
  return root->dump();
}

std::string with_node_weights_of_glb(std::string bytes) {
  constexpr std::size_t header = 12, chunk_header = 8;
  std::uint32_t size = 0;
  std::memcpy(&size, bytes.data() + header, sizeof size);
  const std::string document = bytes.substr(header + chunk_header, size);
  std::string changed = with_node_weights(document);
  if (changed == document) return bytes;
  changed.resize((changed.size() + 3) / 4 * 4, ' ');
  const std::string rest = bytes.substr(header + chunk_header + size);
  const std::string chunks = four_bytes(changed.size()) + "JSON" + changed + rest;
  return bytes.substr(0, 8) + four_bytes(header + chunks.size()) + chunks;
}

}  // namespace pelage
