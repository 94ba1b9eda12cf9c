// Gathers a recipe and the files that it includes into one request; the server turns it into steps.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/status.h"
#include "protocol/commands/recipe.h"

namespace pelage {

/// Returns true if the text is a JSON object that has a recipe's members and is not a command.
bool is_recipe(std::string_view text);

struct RecipeSource {
  std::string file, text;
  std::vector<std::pair<std::string, std::string>> variables = {};  // values are JSON, a number such as .5, or text
  std::string places = {};                                          // JSON text; "" for none
  std::string places_file = {};                                     // path of the places, for error messages
};

/// Returns the recipe with all included files; `read` returns a file's text. Fails on invalid JSON and on more than 64
/// files or 8 MiB; the message names the file.
Result<RecipeRequest> gather_recipe(const RecipeSource& source,
                                    const std::function<Result<std::string>(const std::string& file)>& read);

/// Converts a JSON pointer into the request to a pointer into the file that it refers to.
std::string pointer_in_file(const std::string& pointer);

}  // namespace pelage
