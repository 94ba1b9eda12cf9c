// Faces and texture coordinates by tinyobjloader's callbacks, without a material reader, so that mtllib opens nothing.
// Vertices are read here: tinyobjloader takes `nan` and other words for 0 and gives no vertex colours.
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <array>
#include <istream>
#include <limits>
#include <streambuf>

#include "server/import_worker/parse.h"
#include "server/import_worker/read_picture.h"

namespace pelage {

namespace {

/// A stream over bytes that somebody else owns.
class BytesBuffer : public std::streambuf {
 public:
  explicit BytesBuffer(std::string& bytes) { setg(bytes.data(), bytes.data(), bytes.data() + bytes.size()); }
};

/// A backslash at the end of a line joins the next one; so does a blank of the same length.
void join_continued_lines(std::string& text) {
  for (std::size_t i = text.find('\\'); i != std::string::npos; i = text.find('\\', i + 1)) {
    std::size_t end = i + 1;
    if (end < text.size() && text[end] == '\r') ++end;
    if (end < text.size() && text[end] == '\n') ++end;
    if (end > i + 1) text.replace(i, end - i, end - i, ' ');
  }
}

struct Vertices {
  std::vector<glm::dvec3> positions;  // NaN where a word is no number
  std::vector<glm::vec4> colours;     // of each position; empty when none has one
};

void read_vertex(std::string_view line, Vertices& vertices) {
  std::array<double, 6> numbers;
  numbers.fill(nan);
  for (double& number : numbers) number = to_number(take_word(line)).value_or(nan);
  vertices.positions.emplace_back(numbers[0], numbers[1], numbers[2]);
  if (std::isnan(numbers[5])) return;
  vertices.colours.resize(vertices.positions.size() - 1, glm::vec4(1));
  vertices.colours.emplace_back(srgb_to_linear(glm::vec3(numbers[3], numbers[4], numbers[5])), 1.0f);
}

Vertices read_vertices(std::string_view text) {
  Vertices vertices;
  while (!text.empty()) {
    std::string_view line = take_line(text);
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (line.starts_with("v ") || line.starts_with("v\t")) read_vertex(line.substr(2), vertices);
  }
  if (!vertices.colours.empty()) vertices.colours.resize(vertices.positions.size(), glm::vec4(1));
  return vertices;
}

/// What the callbacks fill.
struct Faces {
  const Vertices& vertices;
  RawModel& model;
  std::size_t vertices_so_far = 0;
  std::vector<glm::dvec2> texture;
};

/// Index of a one-based or, when negative, relative OBJ index; no_position when there is no such item.
std::uint32_t resolve(int index, std::size_t so_far, std::size_t all) {
  const auto wanted = index > 0 ? std::int64_t{index} - 1 : static_cast<std::int64_t>(so_far) + index;
  const bool exists = index != 0 && wanted >= 0 && wanted < static_cast<std::int64_t>(all);
  return exists ? static_cast<std::uint32_t>(wanted) : no_position;
}

void count_vertex(void* data, double, double, double, double) { ++static_cast<Faces*>(data)->vertices_so_far; }

void add_texture(void* data, double u, double v, double) { static_cast<Faces*>(data)->texture.emplace_back(u, v); }

void add_face(void* data, tinyobj::index_t* indices, int count) {
  Faces& faces = *static_cast<Faces*>(data);
  const std::size_t vertices = faces.vertices.positions.size();
  faces.model.face_sizes.push_back(static_cast<std::uint32_t>(count));
  for (int i = 0; i < count; ++i) {
    const std::uint32_t vertex = resolve(indices[i].vertex_index, faces.vertices_so_far, vertices);
    const std::uint32_t uv = resolve(indices[i].texcoord_index, faces.texture.size(), faces.texture.size());
    faces.model.corners.push_back(vertex);
    faces.model.corner_uv.push_back(uv == no_position ? glm::dvec2(nan) : faces.texture[uv]);
    if (faces.vertices.colours.empty()) continue;
    faces.model.corner_colour.push_back(vertex == no_position ? glm::vec4(1) : faces.vertices.colours[vertex]);
  }
}

}  // namespace

Result<RawModel> parse_obj(std::string text) {
  join_continued_lines(text);

  RawModel model;
  Vertices vertices = read_vertices(text);
  Faces faces{vertices, model, 0, {}};
  tinyobj::callback_t callbacks;
  callbacks.vertex_cb = count_vertex;
  callbacks.texcoord_cb = add_texture;
  callbacks.index_cb = add_face;
  BytesBuffer buffer(text);
  std::istream stream(&buffer);
  if (!tinyobj::LoadObjWithCallback(stream, callbacks, &faces)) return broken("the OBJ text cannot be read.");
  if (model.corners.empty()) return broken("it has no faces.");
  model.positions = std::move(vertices.positions);
  if (faces.texture.empty()) model.corner_uv.clear();
  return model;
}

}  // namespace pelage
