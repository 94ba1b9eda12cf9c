#include "protocol/recipes/recipe.h"

#include <nlohmann/json.hpp>

#include "base/limits.h"
#include "protocol/json/decode.h"
#include "protocol/json/parse.h"
#include "protocol/json/reader.h"
#include "protocol/recipes/expand.h"
#include "protocol/recipes/places.h"

namespace pelage {

namespace {

using json_parts::RecipeFile;
using json_parts::Scope;
using nlohmann::json;

/// Parses an object of the request; an empty text is an empty object.
Result<json> object_in(const std::string& text, const std::string& pointer) {
  if (text.empty()) return json(json::object());
  Result<json> tree = parse_json(text);
  if (!tree || tree->is_object()) return tree;
  return failure(Code::invalid, "It is no object.", pointer, "object");
}

/// Puts the values of the request in place of the recipe's own.
Status set_variables(const json& variables, Scope& scope) {
  for (const auto& [name, value] : variables.items()) {
    if (!scope.file.variables.contains(name))
      return failure(Code::invalid, scope.file.name + ": There is no variable \"" + name + "\" to set.",
                     "/variables" + pointer_step(name), "one of \"variables\"",
                     nearest_name(name, json_parts::names_of(scope.file.variables)));
    scope.given[name] = value;
  }
  return {};
}

/// Decodes the commands of a step as POST commands does.
Result<std::vector<Command>> commands_of(const FilledStep& step) {
  if (step.text.size() <= limits::command_body_bytes) return decode_commands(step.text);
  return failure(Code::too_large, "The step has " + std::to_string(step.text.size()) + " bytes.", "",
                 "at most " + std::to_string(limits::command_body_bytes) + " bytes");
}

}  // namespace

Result<std::vector<FilledStep>> fill_recipe(const RecipeRequest& request, const RecipeScene& scene) {
  const Result<json> places = object_in(request.places, "/places");
  if (!places) return places.status();
  if (Status bad = json_parts::check_places(*places, "/places"); !bad.ok()) return bad;
  const Result<json> variables = object_in(request.variables, "/variables");
  if (!variables) return variables.status();
  const Result<json> files = object_in(request.files, "/files");
  if (!files) return files.status();
  const Result<json> recipe = parse_json(request.recipe);
  if (!recipe) return recipe.status();
  json_parts::RecipeReader reader(*files);
  const Result<const RecipeFile*> file = reader.read_all(request.file, *recipe);
  if (!file) return file.status();
  Scope in_file{**file, *places};
  if (Status bad = set_variables(*variables, in_file); !bad.ok()) return bad;
  return json_parts::Expander(scene, *places).expand(in_file);
}

Result<std::vector<RecipeStep>> expand_recipe(const RecipeRequest& request, const RecipeScene& scene) {
  Result<std::vector<FilledStep>> filled = fill_recipe(request, scene);
  if (!filled) return filled.status();
  std::vector<RecipeStep> steps;
  for (FilledStep& step : *filled) {
    Result<std::vector<Command>> commands = commands_of(step);
    if (!commands) {
      Status bad = commands.status();
      bad.message.insert(0, step.file + ": ");
      bad.pointer.insert(0, step.pointer);
      return bad;
    }
    steps.push_back({std::move(*commands), std::move(step.file), std::move(step.pointer), std::move(step.asserts)});
  }
  return steps;
}

}  // namespace pelage
