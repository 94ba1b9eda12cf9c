#include "clients/cli/recipe/recipe.h"

#include <nlohmann/json.hpp>

#include "clients/cli/recipe/expand.h"
#include "clients/cli/recipe/read_places.h"
#include "protocol/json/parse.h"
#include "protocol/json/reader.h"

namespace pelage {

namespace {

using json_parts::recipe_failure;
using json_parts::Scope;
using nlohmann::json;

/// The values that the user sets: JSON where it is that, or a number such as .5, else text.
Status set_variables(const Recipe& recipe, Scope& scope) {
  std::vector<std::string_view> known;
  for (const auto& item : scope.file.variables.items()) known.push_back(item.key());
  for (const auto& [name, text] : recipe.variables) {
    if (!scope.file.variables.contains(name))
      return recipe_failure(recipe.file, "There is no variable \"" + name + "\" to set.",
                            "/variables" + pointer_step(name), "one of \"variables\"", nearest_name(name, known));
    const Result<json> value = parse_json(as_json_number(text));
    scope.given[name] = value ? *value : json(text);
  }
  return {};
}

Status in_file(const std::string& file, const Status& status) {
  return recipe_failure(file, status.message, status.pointer, status.limit, status.nearest);
}

}  // namespace

bool is_recipe(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos || text[begin] != '{') return false;  // long logs need no parsing for this
  const auto tree = parse_json(text);
  if (!tree || !tree->is_object() || tree->contains("op") || tree->contains("commands")) return false;
  return tree->contains("steps") || tree->contains("variables") || tree->contains("include");
}

Result<std::vector<RecipeStep>> expand_recipe(const Recipe& recipe) {
  const Result<json> places = json_parts::read_places(recipe.places);
  if (!places) return in_file(recipe.places_file, places.status());
  json_parts::RecipeReader reader(recipe);
  const Result<const json_parts::RecipeFile*> file = reader.read_all();
  if (!file) return file.status();
  Scope scope{**file, *places};
  if (Status bad = set_variables(recipe, scope); !bad.ok()) return bad;
  return json_parts::Expander(recipe, *places).expand(scope);
}

}  // namespace pelage
