#include "server/export/glb_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

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

void append_item(std::string& list, std::string_view item) {
  if (!list.empty()) list += ',';
  list += item;
}

}  // namespace

std::string json_of(glm::vec3 v) { return fmt::format("[{},{},{}]", v.x, v.y, v.z); }
std::string json_of(glm::dvec3 v) { return fmt::format("[{},{},{}]", v.x, v.y, v.z); }

int GlbWriter::add_view(const void* bytes, std::size_t size, int target) {
  is_full_ = is_full_ || binary_.size() + size + 3 > max_bytes_;
  if (is_full_) return view_count_;  // finish() says so
  binary_.resize((binary_.size() + 3) / 4 * 4, '\0');
  std::string view = fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{})", binary_.size(), size);
  if (target != no_target) view += fmt::format(R"(,"target":{})", target);
  append_item(views_, view + "}");
  binary_.append(static_cast<const char*>(bytes), size);
  return view_count_++;
}

template <class Value>
int GlbWriter::add_vertices(std::span<const Value> values, const char* type, std::string_view bounds) {
  const int view = add_view(values.data(), values.size_bytes(), vertex_data);
  append_item(accessors_, fmt::format(R"({{"bufferView":{},"componentType":{},"count":{},"type":"{}"{}}})", view,
                                      floats, values.size(), type, bounds));
  return accessor_count_++;
}

int GlbWriter::add(std::span<const float> values) { return add_vertices(values, "SCALAR"); }
int GlbWriter::add(std::span<const glm::vec2> values) { return add_vertices(values, "VEC2"); }
int GlbWriter::add(std::span<const glm::vec3> values) { return add_vertices(values, "VEC3"); }
int GlbWriter::add(std::span<const glm::vec4> values) { return add_vertices(values, "VEC4"); }

int GlbWriter::add_positions(std::span<const glm::vec3> values) {
  glm::vec3 low = values.front(), high = low;
  for (const glm::vec3& p : values) low = glm::min(low, p), high = glm::max(high, p);
  return add_vertices(values, "VEC3", fmt::format(R"(,"min":{},"max":{})", json_of(low), json_of(high)));
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
  append_item(accessors_, fmt::format(R"({{"bufferView":{},"componentType":{},"count":{},"type":"SCALAR"}})", view,
                                      few ? shorts : ints, 3 * triangles.size()));
  return accessor_count_++;
}

int GlbWriter::add_png(std::string_view file) {
  const int view = add_view(file.data(), file.size(), no_target);
  append_item(images_, fmt::format(R"({{"bufferView":{},"mimeType":"image/png"}})", view));
  return image_count_++;
}

void GlbWriter::set(std::string_view name, std::string_view json) {
  members_ += fmt::format(R"(,"{}":{})", name, json);
}

Status GlbWriter::too_large() const {
  return failure(Code::too_large, "The file would be larger than a GLB can be.", "",
                 fmt::format("at most {} bytes", max_bytes_));
}

Result<std::string> GlbWriter::finish() const {
  if (is_full_) return too_large();
  std::string json = R"({"asset":{"version":"2.0","generator":"Pelage"})" + members_;
  if (image_count_ > 0) json += fmt::format(R"(,"images":[{}])", images_);
  json += fmt::format(R"(,"accessors":[{}],"bufferViews":[{}],"buffers":[{{"byteLength":{}}}]}})", accessors_, views_,
                      binary_.size());
  json = padded(json, ' ');
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
