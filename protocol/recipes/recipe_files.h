// The files of a recipe, read and checked once.
#pragma once

#include <deque>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/status.h"

namespace pelage::json_parts {

struct RecipeFile {
  std::string name;     // as in refusals
  std::string pointer;  // to it, within the request
  nlohmann::json variables = nlohmann::json::object();
  nlohmann::json steps = nlohmann::json::array();
  std::map<std::string, const RecipeFile*> includes;  // by what `use` calls them
};

/// A refusal that names the file; `pointer` is one within the file.
Status refused_in(const RecipeFile& file, const std::string& message, const std::string& pointer,
                  std::string limit = {}, std::string nearest = {});

/// The name of a file that another one includes, from the folder of the one.
std::string beside(const std::string& file, const std::string& included);

/// The names of an object's members, valid as long as it.
std::vector<std::string_view> names_of(const nlohmann::json& object);

/// Reads a recipe and all that it includes, each file once. Keeps what it read. `files` are documents by name.
class RecipeReader {
 public:
  explicit RecipeReader(const nlohmann::json& files) : documents_(files) {}

  Result<const RecipeFile*> read_all(const std::string& name, const nlohmann::json& document) {
    return read(name, "/recipe", document);
  }

 private:
  Result<const RecipeFile*> read(const std::string& name, const std::string& pointer, const nlohmann::json& document);
  Status include_all(RecipeFile& file, const nlohmann::json& includes);
  Status include(RecipeFile& file, const nlohmann::json& wanted, const std::string& pointer);
  Result<const RecipeFile*> included(const RecipeFile& from, const std::string& name, const std::string& pointer);

  const nlohmann::json& documents_;
  std::deque<RecipeFile> files_;                      // references stay
  std::map<std::string, const RecipeFile*> by_name_;  // those that are read to their end
  std::vector<std::string> open_;                     // the files that are being read, each including the next
};

}  // namespace pelage::json_parts
