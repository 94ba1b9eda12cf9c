#include "clients/cli/recipe/recipe_files.h"

#include <algorithm>
#include <filesystem>

#include "protocol/json/parse.h"
#include "protocol/json/reader.h"

namespace pelage::json_parts {

namespace {

using nlohmann::json;

/// Members that a recipe may have, each of its type.
Status check_members(const std::string& file, const json& tree) {
  if (!tree.is_object()) return recipe_failure(file, "A recipe is a JSON object.", "", "object");
  static const std::map<std::string, json::value_t> known = {{"description", json::value_t::string},
                                                             {"include", json::value_t::array},
                                                             {"steps", json::value_t::array},
                                                             {"variables", json::value_t::object}};
  for (const auto& [name, value] : tree.items()) {
    const auto member = known.find(name);
    if (member == known.end()) {
      return recipe_failure(file, "\"" + name + "\" is not known here.", pointer_step(name), "member of a recipe",
                            nearest_name(name, {"description", "include", "steps", "variables"}));
    }
    if (value.type() != member->second) {
      return recipe_failure(file, "\"" + name + "\" has the wrong type.", pointer_step(name),
                            json(member->second).type_name());
    }
  }
  if (tree.contains("steps")) return {};
  return recipe_failure(file, "The member \"steps\" is missing.", "/steps", "required");
}

std::string beside(const std::string& file, const std::string& name) {
  return (std::filesystem::path(file).parent_path() / name).lexically_normal().generic_string();
}

std::string chain_of(const std::vector<std::string>& files, const std::string& last) {
  std::string chain;
  for (const std::string& file : files) chain += file + " -> ";
  return chain + last;
}

}  // namespace

Status recipe_failure(const std::string& file, const std::string& message, std::string pointer, std::string limit,
                      std::string nearest) {
  return failure(Code::invalid, file + ": " + message, std::move(pointer), std::move(limit), std::move(nearest));
}

Result<const RecipeFile*> RecipeReader::read_all() { return parse(recipe_.file, recipe_.text); }

Result<const RecipeFile*> RecipeReader::parse(const std::string& name, const std::string& text) {
  Result<json> tree = parse_json(text);
  if (!tree) {
    Status status = tree.status();
    status.message.insert(0, name + ": ");
    return status;
  }
  if (Status bad = check_members(name, *tree); !bad.ok()) return bad;
  RecipeFile& file = files_.emplace_back();
  file.name = name;
  file.steps = std::move((*tree)["steps"]);
  if (tree->contains("variables")) file.variables = std::move((*tree)["variables"]);
  if (tree->contains("include")) {
    open_.push_back(std::filesystem::path(name).lexically_normal().generic_string());
    if (Status bad = include_all(file, (*tree)["include"]); !bad.ok()) return bad;
    open_.pop_back();
  }
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
    return recipe_failure(file.name, "What is included is a file, named from the folder of this one.", pointer,
                          "relative path");
  const Result<const RecipeFile*> other = included(file.name, beside(file.name, *text), pointer);
  if (!other) return other.status();
  const std::string name = std::filesystem::path(*text).stem().string();
  if (file.includes.emplace(name, *other).second) return {};
  return recipe_failure(file.name, "Two files that are included are called \"" + name + "\".", pointer,
                        "each name once");
}

Result<const RecipeFile*> RecipeReader::included(const std::string& from, const std::string& name,
                                                 const std::string& pointer) {
  if (std::find(open_.begin(), open_.end(), name) != open_.end())
    return recipe_failure(from, "The files include one another in a circle: " + chain_of(open_, name) + ".", pointer,
                          "no circles");
  if (const auto known = by_name_.find(name); known != by_name_.end()) return known->second;
  if (open_.size() + 1 > static_cast<std::size_t>(recipe_depth))
    return recipe_failure(from, "Files include one another too deeply.", pointer,
                          "at most " + std::to_string(recipe_depth) + " files deep");
  if (files_.size() >= recipe_files)
    return recipe_failure(from, "There are too many files.", pointer,
                          "at most " + std::to_string(recipe_files) + " files");
  const Result<std::string> text = recipe_.read(name);
  if (!text) {
    return with_next(recipe_failure(from, text.status().message, pointer, text.status().limit), text.status().next);
  }
  Result<const RecipeFile*> file = parse(name, *text);
  if (file) by_name_[name] = *file;
  return file;
}

}  // namespace pelage::json_parts
