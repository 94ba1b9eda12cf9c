#include "server/import_worker/parse.h"

#include <charconv>
#include <cstdlib>
#include <string>

#include "server/import_worker/bundle.h"
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

namespace {

bool has_animations(ModelFormat format) { return format == ModelFormat::gltf || format == ModelFormat::glb; }

Result<RawModel> parse_bundle(ModelFormat format, Bundle& bundle, const std::string& pose) {
  std::string& bytes = bundle.model();
  if (bytes.empty()) return broken("the file is empty.");
  if (Status status = check_signature(format, bytes); !status.ok()) return status;
  if (!pose.empty() && !has_animations(format)) return broken("only glTF has poses; load it without one.");
  bytes.erase(0, bytes.size() - without_byte_order_mark(bytes).size());
  switch (format) {
    case ModelFormat::obj: return parse_obj(bundle);
    case ModelFormat::ply: return parse_ply(bytes);
    case ModelFormat::stl: return parse_stl(bytes);
    case ModelFormat::off: return parse_off(bytes);
    case ModelFormat::gltf:
    case ModelFormat::glb:
    case ModelFormat::tds: return parse_with_assimp(format, bundle, pose);
    case ModelFormat::zip: break;
  }
  return broken("the format is unknown.");
}

/// Sets the axes that the file does not give to those that programs which write the format use.
void note_axes(ModelFormat format, RawModel& model) {
  const bool z_is_up = format == ModelFormat::stl || format == ModelFormat::tds;
  if (!model.up) model.up = z_is_up ? Axis::plus_z : Axis::plus_y;
  if (!model.front) model.front = z_is_up ? Axis::minus_y : Axis::plus_z;
}

}  // namespace

Result<RawModel> parse_model(ModelFormat format, std::string bytes, const std::string& pose, bool pictures) {
  Result<Bundle> bundle = format == ModelFormat::zip ? Bundle::unpack(bytes, format) : Bundle(std::move(bytes));
  if (!bundle) return bundle.status();
  if (!pictures) bundle->leave_pictures_out();
  Result<RawModel> model = parse_bundle(format, *bundle, pose);
  if (!model) return model;
  model->pose = pose;
  note_axes(format, *model);
  return model;
}

}  // namespace pelage
