#include "clients/cli/recipe/gather.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/limits.h"
#include "protocol/json/parse.h"
#include "protocol/recipes/fill.h"
#include "protocol/recipes/recipe.h"
#include "protocol/recipes/recipe_files.h"

namespace pelage {

using nlohmann::json;

namespace {

Result<json> parsed(const std::string& file, const std::string& text) {
  Result<json> tree = parse_json(text);
  if (tree) return tree;
  Status status = tree.status();
  status.message.insert(0, file + ": ");
  return status;
}

/// Reads included files recursively, each once. Skips entries that are no valid file name; the server refuses them.
class Gatherer {
 public:
  explicit Gatherer(const std::function<Result<std::string>(const std::string&)>& read) : read_(read) {}

  Status add_included(const std::string& file, const json& document) {
    if (!document.is_object() || !document.contains("include") || !document["include"].is_array()) return {};
    const json& includes = document["include"];
    for (std::size_t k = 0; k < includes.size(); ++k) {
      const std::string* name = includes[k].get_ptr<const std::string*>();
      if (name == nullptr || name->empty() || std::filesystem::path(*name).is_absolute()) continue;
      if (Status bad = add(json_parts::beside(file, *name), file, "/include/" + std::to_string(k)); !bad.ok())
        return bad;
    }
    return {};
  }
  const json& files() const { return files_; }

 private:
  Status add(const std::string& name, const std::string& from, const std::string& pointer) {
    if (files_.contains(name)) return {};
    if (files_.size() >= recipe_files)
      return failure(Code::invalid, from + ": There are too many files.", pointer,
                     "at most " + std::to_string(recipe_files) + " files");
    const Result<std::string> text = read_(name);
    if (!text) {
      const Status& why = text.status();
      return with_next(failure(Code::invalid, from + ": " + why.message, pointer, why.limit), why.next);
    }
    const Result<json> document = parsed(name, *text);
    if (!document) return document.status();
    files_[name] = *document;
    return add_included(name, *document);
  }

  const std::function<Result<std::string>(const std::string&)>& read_;
  json files_ = json::object();
};

/// Returns the values of the variables that the user sets: valid JSON or a number such as .5 as JSON, anything else as
/// text.
json values_of(const std::vector<std::pair<std::string, std::string>>& variables) {
  json values = json::object();
  for (const auto& [name, text] : variables) {
    const Result<json> value = parse_json(as_json_number(text));
    values[name] = value ? *value : json(text);
  }
  return values;
}

}  // namespace

bool is_recipe(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos || text[begin] != '{') return false;  // saves parsing long logs
  const auto tree = parse_json(text);
  if (!tree || !tree->is_object() || tree->contains("op") || tree->contains("commands")) return false;
  return tree->contains("steps") || tree->contains("variables") || tree->contains("include");
}

Result<RecipeRequest> gather_recipe(const RecipeSource& source,
                                    const std::function<Result<std::string>(const std::string& file)>& read) {
  const Result<json> document = parsed(source.file, source.text);
  if (!document) return document.status();
  const Result<json> places = parsed(source.places_file, source.places.empty() ? "{}" : source.places);
  if (!places) return places.status();
  Gatherer included(read);
  if (Status bad = included.add_included(source.file, *document); !bad.ok()) return bad;
  RecipeRequest request{source.file, source.text, json_parts::dumped(included.files()),
                        json_parts::dumped(values_of(source.variables)), source.places};
  const std::size_t bytes = request.recipe.size() + request.files.size();
  if (bytes > limits::recipe_bytes)
    return failure(Code::too_large,
                   source.file + ": It has " + std::to_string(bytes) + " bytes with all that it includes.", "",
                   "at most " + std::to_string(limits::recipe_bytes) + " bytes");
  return request;
}

std::string pointer_in_file(const std::string& pointer) {
  const auto after = [&pointer](std::size_t begin) {
    const std::size_t end = pointer.find('/', begin);
    return end == std::string::npos ? std::string() : pointer.substr(end);
  };
  if (pointer.starts_with("/files/")) return after(std::string_view("/files/").size());
  if (pointer.starts_with("/recipe") || pointer.starts_with("/places")) return after(1);
  return pointer;
}

}  // namespace pelage
