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
  std::string name;     // name in refusals
  std::string pointer;  // JSON pointer to the file, within the request
  nlohmann::json variables = nlohmann::json::object();
  nlohmann::json steps = nlohmann::json::array();
  std::map<std::string, const RecipeFile*> includes;  // by the names that `use` has for them
};

/// Returns a refusal that names the file; `pointer` is one within the file.
Status refused_in(const RecipeFile& file, const std::string& message, const std::string& pointer,
                  std::string limit = {}, std::string nearest = {});

/// Returns the name of a file that `file` includes, from the name that is relative to its folder.
std::string beside(const std::string& file, const std::string& included);

/// Returns the names of an object's members, valid as long as the object.
std::vector<std::string_view> names_of(const nlohmann::json& object);

/// Reads a recipe and all that it includes, each file once, and keeps what it has read. `files` are documents by name.
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
  std::deque<RecipeFile> files_;                      // a deque, so that references stay valid
  std::map<std::string, const RecipeFile*> by_name_;  // files that have been read completely
  std::vector<std::string> include_chain_;            // the files that are being read, each including the next
};

}  // namespace pelage::json_parts
