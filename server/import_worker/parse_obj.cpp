// Parses OBJ. Faces and the materials that they use come from tinyobjloader's callbacks, without a material reader, so
// that mtllib opens no file; material files come from the bundle.
// Vertices are read here: tinyobjloader takes `nan` and other words for 0 and gives no vertex colours.
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <array>
#include <istream>
#include <limits>
#include <map>
#include <sstream>
#include <streambuf>

#include "server/import_worker/bundle.h"
#include "server/import_worker/gltf_json.h"
#include "server/import_worker/parse.h"
#include "server/import_worker/read_picture.h"

namespace pelage {

namespace {

/// A stream buffer over bytes that it does not own.
class BytesBuffer : public std::streambuf {
 public:
  explicit BytesBuffer(std::string& bytes) { setg(bytes.data(), bytes.data(), bytes.data() + bytes.size()); }
};

/// Replaces a backslash at the end of a line, and the line end, by blanks of the same length, which join the next line.
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
  std::vector<glm::vec4> colours;     // linear, one for each position; empty if there are none
  std::vector<glm::dvec2> texture;    // texture coordinates, from given_uv
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

void read_texture(std::string_view line, Vertices& vertices) {
  const double u = to_number(take_word(line)).value_or(nan);
  const std::string_view second = take_word(line);
  vertices.texture.push_back(given_uv(u, second.empty() ? 0 : to_number(second).value_or(nan)));
}

bool takes_keyword(std::string_view& line, std::string_view word) {
  if (!line.starts_with(word) || line.size() == word.size()) return false;
  if (line[word.size()] != ' ' && line[word.size()] != '\t') return false;
  line.remove_prefix(word.size());
  return true;
}

Vertices read_vertices(std::string_view text) {
  Vertices vertices;
  while (!text.empty()) {
    std::string_view line = take_line(text);
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (takes_keyword(line, "v"))
      read_vertex(line, vertices);
    else if (takes_keyword(line, "vt"))
      read_texture(line, vertices);
  }
  if (!vertices.colours.empty()) vertices.colours.resize(vertices.positions.size(), glm::vec4(1));
  return vertices;
}

/// Adds materials to the model as faces use them, each once.
class Materials {
 public:
  Materials(const Bundle& bundle, RawModel& model) : bundle_(bundle), model_(model) {}

  /// Reads all material files that the text names. What follows `mtllib` is one name, or several if there is no file of
  /// that name.
  void read_files(std::string_view text) {
    while (!text.empty()) {
      std::string_view line = take_line(text);
      if (take_word(line) != "mtllib") continue;
      const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
      const std::string names(line.substr(begin, line.find_last_not_of(" \t") + 1 - begin));
      if (!read_file(names)) read_each(names);
    }
  }
  void use(const std::string& name) {
    const auto [entry, added] = numbers_.try_emplace(name, model_.materials.size());
    if (added) model_.materials.push_back(made(name));
    current_ = static_cast<std::uint16_t>(std::min<std::size_t>(entry->second, 0xffff));
  }
  /// Returns the current material, which is white until one is named.
  std::uint16_t current() {
    if (model_.materials.empty()) use("");
    return current_;
  }

 private:
  /// Makes a material. Black with a picture becomes white: many programs write black if there is a picture.
  RawMaterial made(const std::string& name) {
    RawMaterial material{.name = gltf::printable(name)};
    const auto found = known_.find(name);
    if (found == known_.end()) {
      if (!name.empty()) model_.add_loss("missing_materials", name);
      return material;
    }
    const tinyobj::material_t& source = found->second;
    material.base_colour = srgb_to_linear(glm::vec3(source.diffuse[0], source.diffuse[1], source.diffuse[2]));
    if (source.diffuse_texname.empty()) return material;
    material.image = picture(source.diffuse_texname);
    if (material.image >= 0 && material.base_colour == glm::vec3(0)) material.base_colour = glm::vec3(1);
    return material;
  }

  bool read_file(const std::string& name) {
    const std::string* bytes = bundle_.find(name);
    if (!bytes) return false;
    std::istringstream stream(*bytes);
    std::map<std::string, int> numbers;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    tinyobj::LoadMtl(&numbers, &materials, &stream, &warning, &error);
    for (const tinyobj::material_t& material : materials) known_[material.name] = material;
    return true;
  }

  void read_each(std::string_view names) {
    const std::string all(names);
    bool any = false;
    for (std::string_view word = take_word(names); !word.empty(); word = take_word(names))
      any = read_file(std::string(word)) || any;
    if (!any) model_.add_loss("missing_material_files", all);
  }

  int picture(const std::string& name) {
    if (!bundle_.with_pictures()) return -1;
    if (const auto known = pictures_.find(name); known != pictures_.end()) return known->second;
    const std::string* bytes = bundle_.find(name);
    if (!bytes) model_.add_loss("missing_pictures", name);
    return pictures_[name] = bytes ? add_picture(model_, *bytes, name) : -1;
  }

  const Bundle& bundle_;
  RawModel& model_;
  std::map<std::string, tinyobj::material_t> known_;
  std::map<std::string, std::size_t> numbers_;
  std::map<std::string, int> pictures_;
  std::uint16_t current_ = 0;
};

/// The data of the callbacks.
struct Faces {
  const Vertices& vertices;
  RawModel& model;
  Materials& materials;
  std::size_t vertices_so_far = 0, texture_so_far = 0;
};

/// Converts an OBJ index, which counts from 1 or, if negative, back from the newest item, to an index from 0;
/// no_position if there is no such item.
std::uint32_t resolve(int index, std::size_t so_far, std::size_t all) {
  const auto wanted = index > 0 ? std::int64_t{index} - 1 : static_cast<std::int64_t>(so_far) + index;
  const bool exists = index != 0 && wanted >= 0 && wanted < static_cast<std::int64_t>(all);
  return exists ? static_cast<std::uint32_t>(wanted) : no_position;
}

void count_vertex(void* data, double, double, double, double) { ++static_cast<Faces*>(data)->vertices_so_far; }

void count_texture(void* data, double, double, double) { ++static_cast<Faces*>(data)->texture_so_far; }

void add_face(void* data, tinyobj::index_t* indices, int count) {
  Faces& faces = *static_cast<Faces*>(data);
  const std::size_t vertices = faces.vertices.positions.size();
  faces.model.face_sizes.push_back(static_cast<std::uint32_t>(count));
  faces.model.face_material.push_back(faces.materials.current());
  for (int i = 0; i < count; ++i) {
    const std::uint32_t vertex = resolve(indices[i].vertex_index, faces.vertices_so_far, vertices);
    const std::uint32_t uv = resolve(indices[i].texcoord_index, faces.texture_so_far, faces.vertices.texture.size());
    faces.model.corners.push_back(vertex);
    faces.model.corner_uv.push_back(uv == no_position ? glm::dvec2(nan) : faces.vertices.texture[uv]);
    if (faces.vertices.colours.empty()) continue;
    faces.model.corner_colour.push_back(vertex == no_position ? glm::vec4(1) : faces.vertices.colours[vertex]);
  }
}

void use_material(void* data, const char* name, int) { static_cast<Faces*>(data)->materials.use(name ? name : ""); }

}  // namespace

Result<RawModel> parse_obj(Bundle& bundle) {
  std::string& text = bundle.model();
  join_continued_lines(text);

  RawModel model;
  Vertices vertices = read_vertices(text);
  Materials materials(bundle, model);
  materials.read_files(text);
  Faces faces{vertices, model, materials};
  tinyobj::callback_t callbacks;
  callbacks.vertex_cb = count_vertex;
  callbacks.texcoord_cb = count_texture;
  callbacks.index_cb = add_face;
  callbacks.usemtl_cb = use_material;
  BytesBuffer buffer(text);
  std::istream stream(&buffer);
  if (!tinyobj::LoadObjWithCallback(stream, callbacks, &faces)) return broken("the OBJ text cannot be read.");
  if (model.corners.empty()) return broken("it has no faces.");
  model.positions = std::move(vertices.positions);
  if (vertices.texture.empty()) model.corner_uv.clear();
  return model;
}

}  // namespace pelage
