// Recipes: readable JSON files that become steps of commands. They have variables, use one another, and name places by
// their share of the model's box, so that one recipe fits many models.
#pragma once

#include <cstddef>
#include <functional>
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/status.h"

namespace pelage {

inline constexpr std::size_t recipe_file_bytes = std::size_t{1} << 20;
inline constexpr std::size_t recipe_files = 64;      // read for one run
inline constexpr int recipe_depth = 8;               // files that include one another, the first counted
inline constexpr int recipe_variable_depth = 16;     // variables that are made of variables
inline constexpr std::size_t recipe_steps = 10'000;  // of all files and rounds of loops, comments and uses counted
inline constexpr std::size_t recipe_picks = 1'000;
inline constexpr std::size_t recipe_values = 1'000'000;  // JSON values of all steps, variables filled in

/// How many vertices a command has to touch.
struct TouchLimits {
  std::size_t min = 0, max = std::numeric_limits<std::size_t>::max();
};

/// One undo step, and where it stands: `pointer` is a JSON pointer within `file`.
struct RecipeStep {
  std::string text;  // a command or a batch for decode_commands
  std::string file;
  std::string pointer;
  std::vector<std::optional<TouchLimits>> asserts;  // one for each command, or none at all
};

struct Recipe {
  std::string file;  // names it in refusals; what it includes is relative to its folder
  std::string text;
  std::vector<std::pair<std::string, std::string>> variables;  // in place of the recipe's: JSON, or else taken as text
  glm::dvec3 min{0}, max{1};                                   // the box of the model, in its own coordinates
  std::function<Result<std::string>(const std::string& file)> read;  // the text of a file that is included
  /// The server's answer to a pick, both as JSON. A recipe with picks is refused without it.
  std::function<Result<std::string>(const std::string& request)> pick = {};
  std::string places = {};       // JSON of places and sizes by name, in place of variables and picks; "" for none
  std::string places_file = {};  // names it in refusals
};

/// Returns whether the text is a JSON object that is no command but has a recipe's members.
bool is_recipe(std::string_view text);

/// The steps of a recipe: `{"description", "variables": {name: value}, "include": [file], "steps": [...]}`. A step is
/// - a command (`op`) or a batch (`commands`); `assert` beside an `op` is {"min_vertices", "max_vertices"},
/// - the steps of a recipe that is included (`use`: its file's name without the ending, `with`: values for its
///   variables),
/// - a `pick` as POST pick takes it, `as` a variable: the place as shares of the box; "NAME.normal" and so on are the
///   other members of the answer,
/// - a loop (`for`: lists by the variable's name, `steps`), or
/// - a `comment`, which may stand beside the others too.
/// "${name}" as a whole text becomes the variable's value, within a longer text its text; "${a * 2}" is worked out.
/// `{"at": [x, y, z], "by": [x, y, z]}` becomes a position: both are shares of the box, 0 at its lowest corner and 1 at
/// its highest, added up; `by` is optional.
/// Refusals name the file in the message and the JSON pointer within it.
Result<std::vector<RecipeStep>> expand_recipe(const Recipe& recipe);

}  // namespace pelage
