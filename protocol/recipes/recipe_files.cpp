#include "protocol/recipes/recipe_files.h"

#include <algorithm>
#include <filesystem>

#include "protocol/json/parse.h"
#include "protocol/json/reader.h"

namespace pelage::json_parts {

namespace {

using nlohmann::json;

/// Refuses members that a recipe does not have or that are of another type, and a recipe without steps.
Status check_members(const RecipeFile& file, const json& tree) {
  if (!tree.is_object()) return refused_in(file, "A recipe is a JSON object.", "", "object");
  static const std::map<std::string, json::value_t> known = {{"description", json::value_t::string},
                                                             {"include", json::value_t::array},
                                                             {"steps", json::value_t::array},
                                                             {"variables", json::value_t::object}};
  for (const auto& [name, value] : tree.items()) {
    const auto member = known.find(name);
    if (member == known.end()) {
      return refused_in(file, "\"" + name + "\" is not known here.", pointer_step(name), "member of a recipe",
                        nearest_name(name, {"description", "include", "steps", "variables"}));
    }
    if (value.type() != member->second) {
      return refused_in(file, "\"" + name + "\" has the wrong type.", pointer_step(name),
                        json(member->second).type_name());
    }
  }
  if (tree.contains("steps")) return {};
  return refused_in(file, "The member \"steps\" is missing.", "/steps", "required");
}

std::string chain_of(const std::vector<std::string>& files, const std::string& last) {
  std::string chain;
  for (const std::string& file : files) chain += file + " -> ";
  return chain + last;
}

}  // namespace

std::string beside(const std::string& file, const std::string& included) {
  return (std::filesystem::path(file).parent_path() / included).lexically_normal().generic_string();
}

std::vector<std::string_view> names_of(const json& object) {
  std::vector<std::string_view> names;
  for (const auto& item : object.items()) names.push_back(item.key());
  return names;
}

Status refused_in(const RecipeFile& file, const std::string& message, const std::string& pointer, std::string limit,
                  std::string nearest) {
  return failure(Code::invalid, file.name + ": " + message, file.pointer + pointer, std::move(limit),
                 std::move(nearest));
}

Result<const RecipeFile*> RecipeReader::read(const std::string& name, const std::string& pointer,
                                             const json& document) {
  RecipeFile& file = files_.emplace_back();
  file.name = name;
  file.pointer = pointer;
  if (Status bad = check_members(file, document); !bad.ok()) return bad;
  file.steps = document["steps"];
  if (document.contains("variables")) file.variables = document["variables"];
  if (!document.contains("include")) return &file;
  include_chain_.push_back(std::filesystem::path(name).lexically_normal().generic_string());
  if (Status bad = include_all(file, document["include"]); !bad.ok()) return bad;
  include_chain_.pop_back();
  return &file;
}

Status RecipeReader::include_all(RecipeFile& file, const json& includes) {
  for (std::size_t k = 0; k < includes.size(); ++k) {
    if (Status bad = include(file, includes[k], "/include/" + std::to_string(k)); !bad.ok()) return bad;
  }
  return {};
}

Status RecipeReader::include(RecipeFile& file, const json& wanted, const std::string& pointer) {
  const std::string* text = wanted.get_ptr<const std::string*>();
  if (text == nullptr || text->empty() || std::filesystem::path(*text).is_absolute())
    return refused_in(file, "What is included is a file, named from the folder of this one.", pointer, "relative path");
  const Result<const RecipeFile*> other = included(file, beside(file.name, *text), pointer);
  if (!other) return other.status();
  const std::string name = std::filesystem::path(*text).stem().string();
  if (file.includes.emplace(name, *other).second) return {};
  return refused_in(file, "Two files that are included are called \"" + name + "\".", pointer, "each name once");
}

Result<const RecipeFile*> RecipeReader::included(const RecipeFile& from, const std::string& name,
                                                 const std::string& pointer) {
  if (std::find(include_chain_.begin(), include_chain_.end(), name) != include_chain_.end())
    return refused_in(from, "The files include one another in a circle: " + chain_of(include_chain_, name) + ".",
                      pointer, "no circles");
  if (const auto known = by_name_.find(name); known != by_name_.end()) return known->second;
  if (include_chain_.size() + 1 > static_cast<std::size_t>(recipe_depth))
    return refused_in(from, "Files include one another too deeply.", pointer,
                      "at most " + std::to_string(recipe_depth) + " files deep");
  if (files_.size() >= recipe_files)
    return refused_in(from, "There are too many files.", pointer, "at most " + std::to_string(recipe_files) + " files");
  if (!documents_.contains(name))
    return refused_in(from, "The file \"" + name + "\" is not there.", pointer, "one of \"files\"",
                      nearest_name(name, names_of(documents_)));
  Result<const RecipeFile*> file = read(name, "/files" + pointer_step(name), documents_[name]);
  if (file) by_name_[name] = *file;
  return file;
}

}  // namespace pelage::json_parts
