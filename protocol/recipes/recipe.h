// Recipes: readable JSON files that become steps of commands. They have variables, use one another, and name places by
// their share of the model's box, so that one recipe fits many models.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "base/status.h"
#include "protocol/commands/answers.h"
#include "protocol/commands/pick.h"
#include "protocol/commands/recipe.h"

namespace pelage {

inline constexpr std::size_t recipe_text_bytes = std::size_t{1} << 20;  // length of a text with its variables filled in
inline constexpr std::size_t recipe_files = 64;
inline constexpr int recipe_depth = 8;               // depth of includes, counting the first file
inline constexpr int recipe_variable_depth = 16;     // depth of variables that are defined by variables
inline constexpr std::size_t recipe_steps = 10'000;  // in all files and rounds of loops, comments and uses counted
inline constexpr std::size_t recipe_picks = 1'000;
inline constexpr std::size_t recipe_values = 1'000'000;  // in all steps, filled in; 16 bytes of text count as one

/// What a recipe needs from the scene.
struct RecipeScene {
  Bounds box;  // box of the model, in its own coordinates
  std::function<Result<PickAnswer>(const PickRequest&)> pick;
};

/// A step as POST commands takes it, not checked yet.
struct FilledStep {
  std::string text, file, pointer;  // as in RecipeStep
  std::vector<TouchLimits> asserts;
};

/// The steps of a recipe: `{"description", "variables": {name: value}, "include": [file], "steps": [...]}`. A step is
/// - a command (`op`) or a batch (`commands`); `assert` beside an `op` is {"min_vertices", "max_vertices"},
/// - the steps of a recipe that is included (`use`: its file's name without the ending, `with`: values for its
///   variables),
/// - a `pick` as POST pick takes it, `as` a variable that becomes the place, in shares of the box; "NAME.normal" and so
///   on become the other members of the answer,
/// - a loop (`for`: lists by the variable's name, `steps`), or
/// - a `comment`, which may stand beside the others too.
/// "${name}" as a whole text becomes the variable's value, within a longer text its text; "${a * 2}" is evaluated.
/// `{"at": [x, y, z], "by": [x, y, z]}` becomes a position: the sum of both, which are shares of the box, 0 at its
/// lowest corner and 1 at its highest; `by` is optional.
/// Refusals name the file in the message and have a pointer into the request.
Result<std::vector<FilledStep>> fill_recipe(const RecipeRequest& request, const RecipeScene& scene);

/// The same with each step checked and decoded as POST commands does.
Result<std::vector<RecipeStep>> expand_recipe(const RecipeRequest& request, const RecipeScene& scene);

}  // namespace pelage
