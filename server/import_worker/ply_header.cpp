#include "server/import_worker/ply_header.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "server/import_worker/parse.h"
#include "server/import_worker/text.h"

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

/// Fewest bytes that one element takes.
std::size_t least_bytes(const PlyElement& element, PlyEncoding encoding) {
  std::size_t bytes = 0;
  for (const PlyProperty& property : element.properties) {
    const std::size_t binary = size_of(property.is_list ? property.count_type : property.type);
    bytes += encoding == PlyEncoding::text ? 2 : binary;  // a digit and a blank
  }
  return bytes;
}

/// False for a line that is not understood.
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
    const std::size_t least = least_bytes(element, header.encoding);
    if (least > 0 && element.count > bytes.size() / least + 1) {
      return broken("it counts " + std::to_string(element.count) + " of element " + element.name +
                    ", for which it has no room.");
    }
  }
  return header;
}

}  // namespace pelage
