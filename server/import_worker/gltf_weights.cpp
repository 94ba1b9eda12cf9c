#include "server/import_worker/gltf_weights.h"

#include <utility>

namespace pelage {

namespace {

using gltf::json;
using gltf::list;

/// The node's mesh where the node gives weights of its own, else none.
const json* weighted_mesh(const json& node, const json& meshes) {
  if (!node.is_object() || !node.contains("weights") || !node["weights"].is_array()) return nullptr;
  const auto index = node.find("mesh");
  const bool exists = index != node.end() && index->is_number_unsigned() && index->get<std::size_t>() < meshes.size();
  return exists && meshes[index->get<std::size_t>()].is_object() ? &meshes[index->get<std::size_t>()] : nullptr;
}

}  // namespace

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

}  // namespace pelage
