#include "server/export/glb_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <glm/gtc/quaternion.hpp>

namespace pelage {

namespace {

static_assert(std::endian::native == std::endian::little, "GLB is little-endian");

constexpr std::uint32_t magic = 0x46546c67, version = 2;                     // "glTF"
constexpr std::uint32_t json_chunk = 0x4e4f534a, binary_chunk = 0x004e4942;  // "JSON", "BIN"
constexpr std::size_t max_short_indices = 65535;  // vertices; index 65535 itself restarts primitives
constexpr int floats = 5126, shorts = 5123, ints = 5125, vertex_data = 34962, index_data = 34963, no_target = 0;

void append(std::string& bytes, std::uint32_t value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string padded(std::string_view text, char with) {
  std::string bytes(text);
  bytes.resize((bytes.size() + 3) / 4 * 4, with);
  return bytes;
}

void append_chunk(std::string& bytes, std::uint32_t kind, const std::string& content) {
  append(bytes, static_cast<std::uint32_t>(content.size()));
  append(bytes, kind);
  bytes += content;
}

}  // namespace

GltfJson json_of(glm::dvec3 v) { return {v.x, v.y, v.z}; }

int GlbWriter::add_view(const void* bytes, std::size_t size, int target) {
  const int number = static_cast<int>(views_.size());
  is_full_ = is_full_ || binary_.size() + size + 3 > max_bytes_;
  if (is_full_) return number;  // finish() fails
  binary_.resize((binary_.size() + 3) / 4 * 4, '\0');
  GltfJson& view = views_.emplace_back(GltfJson{{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", size}});
  if (target != no_target) view["target"] = target;
  binary_.append(static_cast<const char*>(bytes), size);
  return number;
}

int GlbWriter::add_accessor(int view, int component_type, std::size_t count, const char* type) {
  accessors_.push_back({{"bufferView", view}, {"componentType", component_type}, {"count", count}, {"type", type}});
  return static_cast<int>(accessors_.size()) - 1;
}

template <class Value>
int GlbWriter::add_vertices(std::span<const Value> values, const char* type) {
  return add_accessor(add_view(values.data(), values.size_bytes(), vertex_data), floats, values.size(), type);
}

int GlbWriter::add(std::span<const float> values) { return add_vertices(values, "SCALAR"); }
int GlbWriter::add(std::span<const glm::vec2> values) { return add_vertices(values, "VEC2"); }
int GlbWriter::add(std::span<const glm::vec3> values) { return add_vertices(values, "VEC3"); }
int GlbWriter::add(std::span<const glm::vec4> values) { return add_vertices(values, "VEC4"); }

int GlbWriter::add_positions(std::span<const glm::vec3> values) {
  glm::vec3 low = values.front(), high = low;
  for (const glm::vec3& p : values) low = glm::min(low, p), high = glm::max(high, p);
  const int number = add_vertices(values, "VEC3");
  accessors_.back()["min"] = json_of(low), accessors_.back()["max"] = json_of(high);
  return number;
}

int GlbWriter::add_triangles(std::span<const glm::uvec3> triangles, std::size_t vertices) {
  const bool few = vertices <= max_short_indices;
  int view = 0;
  if (few) {
    const std::vector<glm::u16vec3> narrow(triangles.begin(), triangles.end());
    view = add_view(narrow.data(), narrow.size() * sizeof(glm::u16vec3), index_data);
  } else {
    view = add_view(triangles.data(), triangles.size_bytes(), index_data);
  }
  return add_accessor(view, few ? shorts : ints, 3 * triangles.size(), "SCALAR");
}

int GlbWriter::add_png(std::string_view file) {
  const int view = add_view(file.data(), file.size(), no_target);
  images_.push_back({{"bufferView", view}, {"mimeType", "image/png"}});
  return static_cast<int>(images_.size()) - 1;
}

void GlbWriter::set_sampler(int wrap) {
  constexpr int linear = 9729, trilinear = 9987;
  set("samplers",
      GltfJson::array({{{"magFilter", linear}, {"minFilter", trilinear}, {"wrapS", wrap}, {"wrapT", wrap}}}));
}

GltfJson node_of(const std::string& name, std::size_t mesh, glm::dvec3 centre, const glm::dmat3& turn, double scale) {
  const glm::dquat rotation = glm::quat_cast(turn);
  GltfJson node = {{"name", name}, {"mesh", mesh}, {"translation", json_of(centre)}};
  if (turn != glm::dmat3(1)) node["rotation"] = GltfJson::array({rotation.x, rotation.y, rotation.z, rotation.w});
  if (scale != 1) node["scale"] = json_of(glm::dvec3(scale));
  return node;
}

void GlbWriter::set_scene(GltfJson node, GltfJson primitives, GltfJson extras) {
  GltfJson mesh = {{"primitives", std::move(primitives)}};
  if (!extras.is_null()) mesh["extras"] = std::move(extras);
  set("scene", 0);
  set("scenes", GltfJson::array({{{"nodes", GltfJson::array({0})}}}));
  set("nodes", GltfJson::array({std::move(node)}));
  set("meshes", GltfJson::array({std::move(mesh)}));
}

Status GlbWriter::too_large() const {
  return failure(Code::too_large, "The file would be larger than a GLB can be.", "",
                 fmt::format("at most {} bytes", max_bytes_));
}

Result<std::string> GlbWriter::finish() const {
  if (is_full_) return too_large();
  GltfJson document = document_;
  if (!images_.empty()) document["images"] = images_;
  document["accessors"] = accessors_, document["bufferViews"] = views_;
  document["buffers"] = GltfJson::array({{{"byteLength", binary_.size()}}});
  const std::string json = padded(document.dump(), ' ');
  const std::string binary = padded(binary_, '\0');
  const std::uint64_t size = 28 + json.size() + binary.size();
  if (size > max_bytes_) return too_large();
  std::string bytes;
  bytes.reserve(size);
  append(bytes, magic);
  append(bytes, version);
  append(bytes, static_cast<std::uint32_t>(size));
  append_chunk(bytes, json_chunk, json);
  append_chunk(bytes, binary_chunk, binary);
  return bytes;
}

}  // namespace pelage
