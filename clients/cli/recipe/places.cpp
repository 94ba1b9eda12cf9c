#include "clients/cli/recipe/places.h"

#include <cmath>

#include "clients/cli/recipe/fill.h"
#include "clients/cli/recipe/read_places.h"
#include "protocol/json/parse.h"

namespace pelage {

using nlohmann::json;

namespace {

/// Six digits are a millionth of the box.
double rounded(double share) { return std::round(share * 1e6) / 1e6; }

}  // namespace

namespace json_parts {

Result<json> read_places(std::string_view text) {
  if (text.empty()) return json(json::object());
  Result<json> places = parse_json(text);
  if (!places) return places;
  if (!places->is_object()) return failure(Code::invalid, "Places are an object of names.", "", "object");
  for (const auto& [name, place] : places->items())
    if (!is_triple(place) && !place.is_number())
      return failure(Code::invalid, "A place is three shares of the model's box, a size a number.", pointer_step(name),
                     "[x, y, z] or a number");
  return places;
}

}  // namespace json_parts

Result<std::string> with_place(std::string_view text, const std::string& name, const std::array<double, 3>& shares) {
  Result<json> places = json_parts::read_places(text);
  if (!places) return places.status();
  (*places)[name] = {rounded(shares[0]), rounded(shares[1]), rounded(shares[2])};
  std::string lines;
  for (const auto& [each, place] : places->items())
    lines += (lines.empty() ? "" : ",\n") + ("  " + json_parts::dumped(each)) + ": " + json_parts::dumped(place);
  return "{\n" + lines + "\n}\n";
}

}  // namespace pelage
