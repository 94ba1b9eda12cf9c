#include "server/import_worker/parse.h"

#include <charconv>
#include <cstdlib>
#include <string>

#include "server/import_worker/signature.h"

namespace pelage {

std::optional<double> to_number(std::string_view word) {
  if (!word.empty() && word.front() == '+') {
    word.remove_prefix(1);
    if (!word.empty() && word.front() == '-') return std::nullopt;
  }
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::invalid_argument || end != word.data() + word.size()) return std::nullopt;
  // from_chars does not say whether a number is too large or too small.
  if (error == std::errc::result_out_of_range) return std::strtod(std::string(word).c_str(), nullptr);
  return value;
}

std::string_view take_word(std::string_view& text) {
  constexpr std::string_view blanks = " \t\r\n\v\f";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

std::string_view take_line(std::string_view& text) {
  const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  text.remove_prefix(line.size());
  if (text.starts_with("\r\n"))
    text.remove_prefix(2);
  else if (!text.empty())
    text.remove_prefix(1);
  return line;
}

Result<RawModel> parse_model(ModelFormat format, std::string bytes) {
  if (bytes.empty()) return broken("the file is empty.");
  if (Status status = check_signature(format, bytes); !status.ok()) return status;
  bytes.erase(0, bytes.size() - without_byte_order_mark(bytes).size());
  switch (format) {
    case ModelFormat::obj: return parse_obj(std::move(bytes));
    case ModelFormat::ply: return parse_ply(bytes);
    case ModelFormat::stl: return parse_stl(bytes);
    case ModelFormat::off: return parse_off(bytes);
    case ModelFormat::gltf:
    case ModelFormat::glb:
    case ModelFormat::tds: return parse_with_assimp(format, bytes);
  }
  return broken("the format is unknown.");
}

}  // namespace pelage
