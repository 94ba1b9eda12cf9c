#include "server/import_worker/parse_ply.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "server/import_worker/parse.h"
#include "server/import_worker/read_picture.h"

namespace pelage {

namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr TypeName type_names[] = {
    {"char", PlyType::int8},      {"uchar", PlyType::uint8},    {"short", PlyType::int16},
    {"ushort", PlyType::uint16},  {"int", PlyType::int32},      {"uint", PlyType::uint32},
    {"float", PlyType::float32},  {"double", PlyType::float64}, {"int8", PlyType::int8},
    {"uint8", PlyType::uint8},    {"int16", PlyType::int16},    {"uint16", PlyType::uint16},
    {"int32", PlyType::int32},    {"uint32", PlyType::uint32},  {"float32", PlyType::float32},
    {"float64", PlyType::float64}};

std::optional<PlyType> to_type(std::string_view name) {
  for (const TypeName& known : type_names) {
    if (known.name == name) return known.type;
  }
  return std::nullopt;
}

std::optional<PlyEncoding> to_encoding(std::string_view name) {
  if (name == "ascii") return PlyEncoding::text;
  if (name == "binary_little_endian") return PlyEncoding::little_endian;
  if (name == "binary_big_endian") return PlyEncoding::big_endian;
  return std::nullopt;
}

bool read_element(std::string_view line, PlyHeader& header) {
  PlyElement element;
  element.name = take_word(line);
  const std::string_view count = take_word(line);
  const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), element.count);
  header.elements.push_back(std::move(element));
  return error == std::errc() && end == count.data() + count.size();
}

bool read_property(std::string_view line, PlyHeader& header) {
  if (header.elements.empty()) return false;
  PlyProperty property;
  std::string_view word = take_word(line);
  property.is_list = word == "list";
  if (property.is_list) {
    const std::optional<PlyType> count_type = to_type(take_word(line));
    if (!count_type || *count_type >= PlyType::float32) return false;
    property.count_type = *count_type;
    word = take_word(line);
  }
  const std::optional<PlyType> type = to_type(word);
  property.name = take_word(line);
  if (!type || property.name.empty()) return false;
  property.type = *type;
  header.elements.back().properties.push_back(std::move(property));
  return true;
}

/// Returns the minimum size of one element in bytes.
std::size_t min_bytes(const PlyElement& element, PlyEncoding encoding) {
  std::size_t bytes = 0;
  for (const PlyProperty& property : element.properties) {
    const std::size_t binary = size_of(property.is_list ? property.count_type : property.type);
    bytes += encoding == PlyEncoding::text ? 2 : binary;  // a digit and a blank
  }
  return bytes;
}

/// Reads a line of the header. Returns false if it is malformed.
bool read_line(std::string_view line, PlyHeader& header, bool& has_format) {
  const std::string_view word = take_word(line);
  if (word == "element") return read_element(line, header);
  if (word == "property") return read_property(line, header);
  if (word == "format") {
    const std::optional<PlyEncoding> encoding = to_encoding(take_word(line));
    has_format = encoding.has_value();
    header.encoding = encoding.value_or(PlyEncoding::text);
    return has_format;
  }
  return word.empty() || word == "comment" || word == "obj_info";
}

}  // namespace

std::size_t size_of(PlyType type) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

Result<PlyHeader> take_ply_header(std::string_view& bytes) {
  constexpr std::size_t longest = 65536;
  PlyHeader header;
  bool has_format = false, first = true;
  for (std::size_t taken = 0;; first = false) {
    const std::size_t end = bytes.find('\n');
    taken += end;
    if (end == std::string_view::npos || taken > longest) return broken("its header does not end.");
    std::string_view line = bytes.substr(0, end);
    bytes.remove_prefix(end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (first && line != "ply") return broken("it does not begin with ply.");
    if (line == "end_header") break;
    if (!first && !read_line(line, header, has_format)) return broken("a line of its header is not understood.");
  }
  if (!has_format) return broken("its header names no format.");
  for (const PlyElement& element : header.elements) {
    const std::size_t min = min_bytes(element, header.encoding);
    if (min > 0 && element.count > bytes.size() / min + 1) {
      return broken("it counts " + std::to_string(element.count) + " of element " + element.name +
                    ", for which it has no room.");
    }
  }
  return header;
}

// Polygon File Format, text or binary, polygons or strips of triangles, with vertex colours and texture coordinates.

namespace {

/// Reads the numbers of the body, one after the other. A missing number is read as 0, and ok() is false from then on.
class Numbers {
 public:
  Numbers(std::string_view body, PlyEncoding encoding) : left_(body), encoding_(encoding) {}

  double next(PlyType type) { return encoding_ == PlyEncoding::text ? next_word() : next_binary(type); }
  bool ok() const { return ok_; }
  std::size_t bytes_left() const { return left_.size(); }

 private:
  double next_word() {
    const std::optional<double> number = to_number(take_word(left_));
    ok_ = ok_ && number;
    return number.value_or(0);
  }

  double next_binary(PlyType type) {
    const std::size_t size = size_of(type);
    ok_ = ok_ && size <= left_.size();
    if (!ok_) return 0;
    char bytes[8];
    std::memcpy(bytes, left_.data(), size);
    left_.remove_prefix(size);
    const auto file_order = encoding_ == PlyEncoding::little_endian ? std::endian::little : std::endian::big;
    if (file_order != std::endian::native) std::reverse(bytes, bytes + size);
    switch (type) {
      case PlyType::int8: return as<std::int8_t>(bytes);
      case PlyType::uint8: return as<std::uint8_t>(bytes);
      case PlyType::int16: return as<std::int16_t>(bytes);
      case PlyType::uint16: return as<std::uint16_t>(bytes);
      case PlyType::int32: return as<std::int32_t>(bytes);
      case PlyType::uint32: return as<std::uint32_t>(bytes);
      case PlyType::float32: return as<float>(bytes);
      case PlyType::float64: return as<double>(bytes);
    }
    return 0;
  }

  template <class T>
  static double as(const char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<double>(value);
  }

  std::string_view left_;
  PlyEncoding encoding_;
  bool ok_ = true;
};

/// Reads the length of a list; none if it is no whole number, or the remaining bytes have no room for the list.
std::optional<std::size_t> take_count(Numbers& numbers, PlyType type) {
  const double count = numbers.next(type);
  const bool good =
      numbers.ok() && count >= 0 && count <= static_cast<double>(numbers.bytes_left()) && count == std::floor(count);
  return good ? std::optional(static_cast<std::size_t>(count)) : std::nullopt;
}

double full_scale(PlyType type) {
  if (type == PlyType::uint8) return 255;
  return type == PlyType::uint16 ? 65535 : 1;
}

struct PlyVertex {
  glm::dvec3 position{nan};
  glm::dvec3 colour{nan};  // sRGB, [0, 1]
  glm::dvec2 uv{nan};
};

/// Returns the member of `vertex` for a property; null for an unknown property.
double* member_of(PlyVertex& vertex, std::string_view name) {
  struct Name {
    std::string_view name;
    double* member;
  };
  const Name names[] = {{"x", &vertex.position.x}, {"y", &vertex.position.y},   {"z", &vertex.position.z},
                        {"red", &vertex.colour.x}, {"green", &vertex.colour.y}, {"blue", &vertex.colour.z},
                        {"r", &vertex.colour.x},   {"g", &vertex.colour.y},     {"b", &vertex.colour.z},
                        {"s", &vertex.uv.x},       {"t", &vertex.uv.y},         {"u", &vertex.uv.x},
                        {"v", &vertex.uv.y},       {"texture_u", &vertex.uv.x}, {"texture_v", &vertex.uv.y}};
  for (const Name& entry : names) {
    if (entry.name == name) return entry.member;
  }
  return nullptr;
}

class BodyReader {
 public:
  BodyReader(std::string_view body, const PlyHeader& header) : numbers_(body, header.encoding), header_(header) {}

  Result<RawModel> read() {
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;
      for (std::uint64_t i = 0; i < element.count; ++i) {
        const bool good = element.name == "vertex" ? read_vertex(element) : read_other(element);
        if (!good) return broken("element " + element.name + " " + std::to_string(i) + " is cut off or broken.");
      }
    }
    if (model_.face_sizes.empty()) return broken("it has no faces.");
    fill_corners();
    return std::move(model_);
  }

 private:
  bool read_vertex(const PlyElement& element) {
    PlyVertex vertex;
    for (const PlyProperty& property : element.properties) {
      if (property.is_list) {
        if (!skip_list(property)) return false;
        continue;
      }
      const double value = numbers_.next(property.type);
      double* member = member_of(vertex, property.name);
      if (!member) continue;
      const bool is_colour = member >= &vertex.colour.x && member <= &vertex.colour.z;
      *member = is_colour ? value / full_scale(property.type) : value;
      const bool is_position = member >= &vertex.position.x && member <= &vertex.position.z;
      if (is_position && header_.encoding != PlyEncoding::text && property.type != PlyType::float64) {
        model_.is_32_bit = true;
      }
    }
    vertices_.push_back(vertex);
    return numbers_.ok();
  }

  /// Reads faces and strips, and skips all other elements.
  bool read_other(const PlyElement& element) {
    for (const PlyProperty& property : element.properties) {
      const bool is_face = element.name == "face" && property.is_list &&
                           (property.name == "vertex_indices" || property.name == "vertex_index");
      const bool is_strip = element.name == "tristrips" && property.is_list && property.name == "vertex_indices";
      if (is_face && !read_face(property)) return false;
      if (is_strip && !read_strip(property)) return false;
      if (!is_face && !is_strip && property.is_list && !skip_list(property)) return false;
      if (!is_face && !property.is_list) numbers_.next(property.type);
    }
    return numbers_.ok();
  }

  bool skip_list(const PlyProperty& property) {
    const std::optional<std::size_t> count = take_count(numbers_, property.count_type);
    for (std::size_t i = 0; count && i < *count; ++i) numbers_.next(property.type);
    return count.has_value() && numbers_.ok();
  }

  /// Reads an index; no_position if it is invalid.
  std::uint32_t next_index(PlyType type) {
    const double index = numbers_.next(type);
    const bool is_index = index >= 0 && index < no_position && index == std::floor(index);
    return is_index ? static_cast<std::uint32_t>(index) : no_position;
  }

  /// Reads triangle strips: every second triangle has the opposite winding, and -1 begins a new strip.
  bool read_strip(const PlyProperty& property) {
    const std::optional<std::size_t> count = take_count(numbers_, property.count_type);
    if (!count) return false;
    std::vector<std::uint32_t> strip;
    for (std::size_t i = 0; i < *count; ++i) {
      strip.push_back(next_index(property.type));
      if (strip.back() == no_position) strip.clear();
      const std::size_t n = strip.size();
      if (n < 3) continue;
      const bool odd = n % 2 == 0;
      model_.face_sizes.push_back(3);
      model_.corners.insert(model_.corners.end(),
                            {strip[n - 3], strip[odd ? n - 1 : n - 2], strip[odd ? n - 2 : n - 1]});
    }
    return numbers_.ok();
  }

  bool read_face(const PlyProperty& property) {
    const std::optional<std::size_t> count = take_count(numbers_, property.count_type);
    if (!count) return false;
    for (std::size_t i = 0; i < *count; ++i) {
      model_.corners.push_back(next_index(property.type));
    }
    if (*count > 0) model_.face_sizes.push_back(static_cast<std::uint32_t>(*count));
    return numbers_.ok();
  }

  /// Fills the corners at the end, because faces may come before vertices.
  void fill_corners() {
    for (const PlyVertex& vertex : vertices_) model_.positions.push_back(vertex.position);
    const auto has = [&](auto known) { return std::any_of(vertices_.begin(), vertices_.end(), known); };
    const bool colours = has([](const PlyVertex& v) { return !std::isnan(v.colour.x + v.colour.y + v.colour.z); });
    const bool uvs = has([](const PlyVertex& v) { return !std::isnan(v.uv.x + v.uv.y); });
    for (std::uint32_t& corner : model_.corners) {
      if (corner >= vertices_.size()) corner = no_position;
      const PlyVertex vertex = corner == no_position ? PlyVertex() : vertices_[corner];
      if (colours) model_.corner_colour.emplace_back(srgb_to_linear(glm::vec3(vertex.colour)), 1.0f);
      if (uvs) model_.corner_uv.push_back(given_uv(vertex.uv.x, vertex.uv.y));
    }
  }

  Numbers numbers_;
  const PlyHeader& header_;
  std::vector<PlyVertex> vertices_;
  RawModel model_;
};

}  // namespace

Result<RawModel> parse_ply(const std::string& bytes) {
  std::string_view body = bytes;
  const Result<PlyHeader> header = take_ply_header(body);
  if (!header.ok()) return header.status();
  return BodyReader(body, *header).read();
}

}  // namespace pelage
