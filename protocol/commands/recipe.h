// Recipes: grooms as readable files, which the server turns into steps of commands for a model.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocol/commands/command.h"

namespace pelage {

/// A recipe with all that it is made of. Texts of JSON, all together at most limits::recipe_bytes.
struct RecipeRequest {
  std::string file = "recipe.json";  // names the recipe in refusals; what it includes is relative to its folder
  std::string recipe;                // the document
  std::string files = {};            // what is included, documents by name: {"folder/dot.json": {...}}
  std::string variables = {};        // values in place of the recipe's, by name
  std::string places = {};           // places and sizes by name, in place of variables and picks
};

/// How many vertices a command of a step has to touch.
struct TouchLimits {
  std::uint64_t command = 0;  // of the step, from 0
  std::optional<std::uint64_t> min_vertices = {}, max_vertices = {};
};

/// One undo step, and where it stands.
struct RecipeStep {
  std::vector<Command> commands;  // 1 to 1,000
  std::string file;               // that the step stands in
  std::string pointer;            // to the step, within the request
  std::vector<TouchLimits> asserts = {};
};

struct RecipeAnswer {
  std::uint64_t revision = 0;  // of the scene that picks were made in
  std::vector<RecipeStep> steps;
};

}  // namespace pelage
