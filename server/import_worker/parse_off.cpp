// Parses the Object File Format, text: [ST][C][N]OFF, the counts, a line for each vertex and for each face.
#include <array>
#include <limits>

#include "server/import_worker/parse.h"
#include "server/import_worker/read_picture.h"

namespace pelage {

namespace {

/// Removes the text up to the next line with more than blanks and a comment, and returns that line without its comment;
/// empty at the end.
std::string_view take_full_line(std::string_view& text) {
  while (!text.empty()) {
    std::string_view line = take_line(text);
    line = line.substr(0, line.find('#'));
    if (line.find_first_not_of(" \t\v\f") != std::string_view::npos) return line;
  }
  return {};
}

/// Parses a whole number in [0, 2^32 - 2]; no_position for anything else.
std::uint32_t to_index(std::string_view word) {
  const double value = to_number(word).value_or(-1);
  return value >= 0 && value < no_position && value == static_cast<std::uint32_t>(value)
             ? static_cast<std::uint32_t>(value)
             : no_position;
}

struct Header {
  bool has_texture = false, has_colour = false, has_normal = false;
  std::uint32_t vertices = 0, faces = 0;
};

bool take_prefix(std::string_view& word, std::string_view prefix) {
  if (!word.starts_with(prefix)) return false;
  word.remove_prefix(prefix.size());
  return true;
}

Result<Header> read_header(std::string_view& text) {
  Header header;
  std::string_view line = take_full_line(text);
  std::string_view word = take_word(line);
  header.has_texture = take_prefix(word, "ST");
  header.has_colour = take_prefix(word, "C");
  header.has_normal = take_prefix(word, "N");
  if (word != "OFF") return broken("it does not begin with OFF, or is a kind of OFF that is not read (4OFF, nOFF).");
  if (line.find_first_not_of(" \t\v\f") == std::string_view::npos) line = take_full_line(text);
  header.vertices = to_index(take_word(line));
  header.faces = to_index(take_word(line));
  // A vertex takes six bytes or more, a face two.
  if (header.vertices > text.size() / 6 + 1 || header.faces > text.size() / 2 + 1) {
    return broken("its counts are no numbers, or larger than what follows.");
  }
  return header;
}

struct OffVertex {
  glm::dvec3 position{0};
  glm::vec4 colour{1};
  glm::dvec2 uv{nan};
};

double take_number(std::string_view& line, bool& good) {
  const std::optional<double> number = to_number(take_word(line));
  good = good && number;
  return number.value_or(nan);
}

/// Reads a vertex. Returns false if the line lacks one of the three numbers or a normal or colour that the header
/// promises. Colours are in [0, 1], or bytes if a channel is above 1.
bool read_vertex(std::string_view line, const Header& header, OffVertex& vertex) {
  bool good = true;
  for (int i = 0; i < 3; ++i) vertex.position[i] = take_number(line, good);
  for (int i = 0; i < 3 && header.has_normal; ++i) take_number(line, good);
  if (header.has_colour) {
    glm::vec3 colour(0);
    for (int i = 0; i < 3; ++i) colour[i] = static_cast<float>(take_number(line, good));
    const bool bytes = colour.x > 1 || colour.y > 1 || colour.z > 1;
    vertex.colour = glm::vec4(srgb_to_linear(bytes ? colour / 255.0f : colour), 1);
  }
  if (header.has_texture) {
    // An alpha may stand between the colour and the texture coordinates, so these are the last two.
    std::array<double, 3> rest = {nan, nan, nan};
    int count = 0;
    for (std::string_view word = take_word(line); !word.empty() && count < 3; word = take_word(line)) {
      rest[static_cast<std::size_t>(count++)] = to_number(word).value_or(nan);
    }
    if (count >= 2) vertex.uv = {rest[static_cast<std::size_t>(count - 2)], rest[static_cast<std::size_t>(count - 1)]};
  }
  return good;
}

/// Reads a face. Returns false if the line has fewer indices than its count. Invalid indices become no_position.
bool read_face(std::string_view line, RawModel& model) {
  const std::uint32_t size = to_index(take_word(line));
  if (size == no_position || size > line.size()) return false;
  for (std::uint32_t i = 0; i < size; ++i) {
    const std::string_view word = take_word(line);
    if (word.empty()) return false;
    const std::uint32_t index = to_index(word);
    model.corners.push_back(index < model.positions.size() ? index : no_position);
  }
  if (size > 0) model.face_sizes.push_back(size);
  return true;
}

}  // namespace

Result<RawModel> parse_off(const std::string& bytes) {
  std::string_view text = bytes;
  const Result<Header> header = read_header(text);
  if (!header.ok()) return header.status();
  RawModel model;
  std::vector<OffVertex> vertices;
  for (std::uint32_t i = 0; i < header->vertices; ++i) {
    OffVertex vertex;
    if (!read_vertex(take_full_line(text), *header, vertex)) {
      return broken("vertex " + std::to_string(i) + " is cut off or no list of numbers.");
    }
    model.positions.push_back(vertex.position);
    vertices.push_back(vertex);
  }
  for (std::uint32_t i = 0; i < header->faces; ++i) {
    if (!read_face(take_full_line(text), model)) {
      return broken("face " + std::to_string(i) + " has fewer indices than it says.");
    }
  }
  if (model.corners.empty()) return broken("it has no faces.");
  for (std::uint32_t corner : model.corners) {
    const OffVertex vertex = corner == no_position ? OffVertex() : vertices[corner];
    if (header->has_colour) model.corner_colour.push_back(vertex.colour);
    if (header->has_texture) model.corner_uv.push_back(vertex.uv);
  }
  return model;
}

}  // namespace pelage
