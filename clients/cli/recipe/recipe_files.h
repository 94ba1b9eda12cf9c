// The files of a recipe, read and checked once.
#pragma once

#include <deque>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "clients/cli/recipe/recipe.h"

namespace pelage::json_parts {

struct RecipeFile {
  std::string name;  // as in refusals
  nlohmann::json variables = nlohmann::json::object();
  nlohmann::json steps = nlohmann::json::array();
  std::map<std::string, const RecipeFile*> includes;  // by what `use` calls them
};

/// A refusal that names the file.
Status recipe_failure(const std::string& file, const std::string& message, std::string pointer, std::string limit = {},
                      std::string nearest = {});

/// Reads a recipe and all that it includes, each file once. Keeps what it read.
class RecipeReader {
 public:
  explicit RecipeReader(const Recipe& recipe) : recipe_(recipe) {}

  Result<const RecipeFile*> read_all();

 private:
  Result<const RecipeFile*> parse(const std::string& name, const std::string& text);
  Status include_all(RecipeFile& file, const nlohmann::json& includes);
  Status include(RecipeFile& file, const nlohmann::json& wanted, const std::string& pointer);
  Result<const RecipeFile*> included(const std::string& from, const std::string& name, const std::string& pointer);

  const Recipe& recipe_;
  std::deque<RecipeFile> files_;                      // references stay
  std::map<std::string, const RecipeFile*> by_name_;  // those that are read to their end
  std::vector<std::string> open_;                     // the files that are being read, each including the next
};

}  // namespace pelage::json_parts
