// Recipes: grooms as readable files, which the server turns into steps of commands for a model.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocol/commands/command.h"

namespace pelage {

/// A recipe and all that it includes, as JSON texts of at most limits::recipe_bytes in total.
struct RecipeRequest {
  std::string file = "recipe.json";  // name of the recipe in refusals; included files are relative to its folder
  std::string recipe;                // the document
  std::string files = {};            // included documents by name: {"folder/dot.json": {...}}
  std::string variables = {};        // values by name that replace those of the recipe's variables
  std::string places = {};           // places and sizes by name that replace variables and picks
};

/// Limits on how many vertices a command of a step touches.
struct TouchLimits {
  std::uint64_t command = 0;  // index of the command in the step
  std::optional<std::uint64_t> min_vertices = {}, max_vertices = {};
};

/// One undo step, and where the recipe states it.
struct RecipeStep {
  std::vector<Command> commands;  // 1 to 1,000
  std::string file;               // name of the file that contains the step
  std::string pointer;            // JSON pointer to the step, within the request
  std::vector<TouchLimits> asserts = {};
};

struct RecipeAnswer {
  std::uint64_t revision = 0;  // revision of the scene that picks were made in
  std::vector<RecipeStep> steps;
};

}  // namespace pelage
