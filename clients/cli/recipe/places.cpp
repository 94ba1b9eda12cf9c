#include "clients/cli/recipe/places.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "protocol/json/parse.h"
#include "protocol/recipes/places.h"

namespace pelage {

using nlohmann::json;

namespace {

/// Rounds a fraction of the box to six decimal places.
double rounded(double share) { return std::round(share * 1e6) / 1e6; }

}  // namespace

Result<std::string> with_place(std::string_view text, const std::string& name, const std::array<double, 3>& shares) {
  Result<json> places = text.empty() ? Result<json>(json::object()) : parse_json(text);
  if (!places) return places.status();
  if (Status bad = json_parts::check_places(*places, ""); !bad.ok()) return bad;
  (*places)[name] = {rounded(shares[0]), rounded(shares[1]), rounded(shares[2])};
  std::string lines;
  for (const auto& [each, place] : places->items())
    lines += (lines.empty() ? "" : ",\n") + ("  " + json(each).dump()) + ": " + place.dump();
  return "{\n" + lines + "\n}\n";
}

}  // namespace pelage
