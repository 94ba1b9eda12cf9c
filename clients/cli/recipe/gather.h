// A recipe's files, put together into what the server turns into steps.
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

/// Returns whether the text is a JSON object that is no command but has a recipe's members.
bool is_recipe(std::string_view text);

struct RecipeSource {
  std::string file, text;
  std::vector<std::pair<std::string, std::string>> variables = {};  // values are JSON, a number such as .5, or text
  std::string places = {};                                          // JSON; "" for none
  std::string places_file = {};                                     // names them in refusals
};

/// The recipe with all that it includes, whose texts `read` gives. Refuses what is no JSON, and more than 64 files or
/// 8 MiB; the message names the file.
Result<RecipeRequest> gather_recipe(const RecipeSource& source,
                                    const std::function<Result<std::string>(const std::string& file)>& read);

/// A pointer into the request as one into the file that it leads to.
std::string pointer_in_file(const std::string& pointer);

}  // namespace pelage
