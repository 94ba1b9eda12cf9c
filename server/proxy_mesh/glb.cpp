#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstring>

#include "server/proxy_mesh/proxy_mesh.h"

namespace pelage {

namespace {

static_assert(std::endian::native == std::endian::little, "GLB is little-endian");

constexpr std::uint32_t magic = 0x46546c67, version = 2;                     // "glTF"
constexpr std::uint32_t json_chunk = 0x4e4f534a, binary_chunk = 0x004e4942;  // "JSON", "BIN"
constexpr std::size_t max_short_indices = 65535;  // vertices; index 65535 itself restarts primitives

bool has_short_indices(const ProxyMesh& mesh) { return mesh.positions.size() <= max_short_indices; }

template <class T>
void append(std::string& bytes, const std::vector<T>& values) {
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

void append(std::string& bytes, std::uint32_t value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void pad(std::string& bytes, char with) { bytes.resize((bytes.size() + 3) / 4 * 4, with); }

std::string binary_of(const ProxyMesh& mesh) {
  std::string bytes;
  append(bytes, mesh.positions);
  append(bytes, mesh.normals);
  if (has_short_indices(mesh)) {
    std::vector<glm::u16vec3> triangles(mesh.triangles.begin(), mesh.triangles.end());
    append(bytes, triangles);
  } else {
    append(bytes, mesh.triangles);
  }
  return bytes;
}

/// Each number in the fewest digits that give it again.
template <class Vector>
std::string list_of(const Vector& v) {
  return fmt::format("[{},{},{}]", v.x, v.y, v.z);
}

std::string json_of(const ProxyMesh& mesh, std::size_t binary_bytes) {
  constexpr int floats = 5126, shorts = 5123, ints = 5125, vertex_data = 34962, index_data = 34963;
  glm::vec3 low = mesh.positions.front(), high = low;
  for (const glm::vec3& p : mesh.positions) low = glm::min(low, p), high = glm::max(high, p);
  const std::size_t vertices = mesh.positions.size(), vector_bytes = vertices * sizeof(glm::vec3);
  std::string json =
      fmt::format(R"({{"asset":{{"version":"2.0","generator":"Pelage"}},"scene":0,"scenes":[{{"nodes":[0]}}],)"
                  R"("nodes":[{{"mesh":0,"translation":{}}}],)"
                  R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,"NORMAL":1}},"indices":2}}]}}],)",
                  list_of(mesh.centre));
  json += fmt::format(
      R"("accessors":[{{"bufferView":0,"componentType":{0},"count":{1},"type":"VEC3","min":{2},"max":{3}}},)"
      R"({{"bufferView":1,"componentType":{0},"count":{1},"type":"VEC3"}},)",
      floats, vertices, list_of(low), list_of(high));
  json += fmt::format(R"({{"bufferView":2,"componentType":{},"count":{},"type":"SCALAR"}}],)",
                      has_short_indices(mesh) ? shorts : ints, 3 * mesh.triangles.size());
  json += fmt::format(
      R"("bufferViews":[{{"buffer":0,"byteLength":{0},"target":{1}}},)"
      R"({{"buffer":0,"byteOffset":{0},"byteLength":{0},"target":{1}}},)"
      R"({{"buffer":0,"byteOffset":{2},"byteLength":{3},"target":{4}}}],"buffers":[{{"byteLength":{5}}}]}})",
      vector_bytes, vertex_data, 2 * vector_bytes, binary_bytes - 2 * vector_bytes, index_data, binary_bytes);
  return json;
}

void append_chunk(std::string& bytes, std::uint32_t kind, const std::string& content) {
  append(bytes, static_cast<std::uint32_t>(content.size()));
  append(bytes, kind);
  bytes += content;
}

}  // namespace

std::string glb_of(const ProxyMesh& mesh) {
  std::string binary = binary_of(mesh);
  std::string json = json_of(mesh, binary.size());
  pad(json, ' ');
  pad(binary, '\0');
  std::string bytes;
  bytes.reserve(28 + json.size() + binary.size());
  append(bytes, magic);
  append(bytes, version);
  append(bytes, static_cast<std::uint32_t>(28 + json.size() + binary.size()));
  append_chunk(bytes, json_chunk, json);
  append_chunk(bytes, binary_chunk, binary);
  return bytes;
}

}  // namespace pelage
