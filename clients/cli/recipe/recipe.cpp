#include "clients/cli/recipe/recipe.h"

#include <nlohmann/json.hpp>

#include "clients/cli/recipe/recipe_files.h"
#include "protocol/json/parse.h"
#include "protocol/json/reader.h"

namespace pelage {

namespace {

using json_parts::recipe_failure;
using json_parts::RecipeFile;
using json_parts::RecipeReader;
using nlohmann::json;

/// What the variables of a file are worth in one use of it.
struct Scope {
  const RecipeFile& file;
  json given = json::object();  // values for this use, filled in already
};

bool is_triple(const json& value) {
  return value.is_array() && value.size() == 3 && value[0].is_number() && value[1].is_number() && value[2].is_number();
}

/// {"at": [...]} or {"at": [...], "by": [...]}. A colour ramp has an `at` too, which is a number.
bool is_place(const json& value) {
  return value.is_object() && value.contains("at") && value["at"].is_array() &&
         value.size() == (value.contains("by") ? 2u : 1u);
}

std::string dumped(const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

/// A copy of values with variables and places filled in. The first refusal is kept; after it copies are empty.
class Filler {
 public:
  explicit Filler(const Recipe& recipe) : recipe_(recipe) {}

  const Status& status() const { return status_; }

  json fill(const json& value, const Scope& scope, const std::string& pointer) {
    if (!status_.ok()) return {};
    if (++values_ > recipe_values)
      return refuse(scope, "The steps are too much with their variables filled in.", pointer,
                    "at most " + std::to_string(recipe_values) + " values");
    if (value.is_string()) return fill_text(value.get_ref<const std::string&>(), scope, pointer);
    if (!value.is_structured()) return value;
    json copy = value.is_array() ? json::array() : json::object();
    if (value.is_array()) {
      for (std::size_t k = 0; k < value.size(); ++k)
        copy.push_back(fill(value[k], scope, pointer + "/" + std::to_string(k)));
    } else {
      for (const auto& [name, member] : value.items()) copy[name] = fill(member, scope, pointer + pointer_step(name));
    }
    return is_place(copy) ? position(copy, scope, pointer) : copy;
  }

  json refuse(const Scope& scope, const std::string& message, std::string pointer, std::string limit,
              std::string nearest = {}) {
    if (status_.ok())
      status_ = recipe_failure(scope.file.name, message, std::move(pointer), std::move(limit), std::move(nearest));
    return {};
  }

 private:
  json fill_text(const std::string& text, const Scope& scope, const std::string& pointer) {
    std::string filled;
    std::size_t at = 0;
    for (std::size_t begin; (begin = text.find("${", at)) != std::string::npos;) {
      const std::size_t end = text.find('}', begin);
      if (end == std::string::npos) return refuse(scope, "A \"${\" is not closed.", pointer, "${name}");
      const json value = variable(text.substr(begin + 2, end - begin - 2), scope, pointer);
      if (begin == 0 && end + 1 == text.size()) return value;
      if (value.is_structured())
        return refuse(scope, "A list or an object cannot stand within a text.", pointer, "text or number");
      filled += text.substr(at, begin - at) + (value.is_string() ? value.get<std::string>() : dumped(value));
      at = end + 1;
      if (filled.size() > recipe_file_bytes)
        return refuse(scope, "The text is too long.", pointer,
                      "at most " + std::to_string(recipe_file_bytes) + " bytes");
    }
    return filled + text.substr(at);
  }

  json variable(const std::string& name, const Scope& scope, const std::string& pointer) {
    if (const auto given = scope.given.find(name); given != scope.given.end()) return count(*given, scope, pointer);
    const auto own = scope.file.variables.find(name);
    if (own == scope.file.variables.end()) {
      std::vector<std::string_view> known;
      for (const auto& item : scope.file.variables.items()) known.push_back(item.key());
      return refuse(scope, "There is no variable \"" + name + "\".", pointer, "one of \"variables\"",
                    nearest_name(name, known));
    }
    if (depth_ == recipe_variable_depth)
      return refuse(scope, "Variables are made of one another too deeply or in a circle.", pointer,
                    "at most " + std::to_string(recipe_variable_depth) + " deep");
    ++depth_;
    json value = fill(*own, scope, "/variables" + pointer_step(name));
    --depth_;
    return value;
  }

  /// A value that is filled in already counts as often as it is copied.
  json count(const json& value, const Scope& scope, const std::string& pointer) {
    values_ += value.is_structured() ? dumped(value).size() / 2 : 1;
    if (values_ <= recipe_values) return value;
    return refuse(scope, "The steps are too much with their variables filled in.", pointer,
                  "at most " + std::to_string(recipe_values) + " values");
  }

  json position(const json& place, const Scope& scope, const std::string& pointer) {
    if (!is_triple(place["at"]) || (place.contains("by") && !is_triple(place["by"])))
      return refuse(scope, "A place is three shares of the model's box.", pointer, "[x, y, z]");
    json position = json::array();
    for (int k = 0; k < 3; ++k) {
      const double share = place["at"][k].get<double>() + (place.contains("by") ? place["by"][k].get<double>() : 0);
      position.push_back(recipe_.min[k] + share * (recipe_.max[k] - recipe_.min[k]));
    }
    return position;
  }

  const Recipe& recipe_;
  std::size_t values_ = 0;
  int depth_ = 0;
  Status status_;
};

/// Goes through the steps of a file and of those that it uses.
class Expander {
 public:
  explicit Expander(const Recipe& recipe) : filler_(recipe) {}

  Result<std::vector<RecipeStep>> expand(const Scope& scope) {
    add_steps(scope);
    if (!filler_.status().ok()) return filler_.status();
    if (steps_.empty()) return recipe_failure(scope.file.name, "There are no commands in it.", "/steps", "1 or more");
    return std::move(steps_);
  }

 private:
  void add_steps(const Scope& scope) {
    for (std::size_t k = 0; k < scope.file.steps.size() && filler_.status().ok(); ++k)
      add_step(scope.file.steps[k], scope, "/steps/" + std::to_string(k));
  }

  void add_step(json step, const Scope& scope, const std::string& pointer) {
    if (++count_ > recipe_steps) {
      filler_.refuse(scope, "There are too many steps.", pointer, "at most " + std::to_string(recipe_steps));
      return;
    }
    if (!step.is_object()) {
      filler_.refuse(scope, "A step is an object.", pointer, "op | commands | use | comment");
      return;
    }
    const bool comment = step.erase("comment") > 0;
    if (comment && step.empty()) return;
    if (step.contains("use")) {
      use(step, scope, pointer);
    } else if (step.contains("op") || step.contains("commands")) {
      json filled = filler_.fill(step, scope, pointer);
      if (filler_.status().ok()) steps_.push_back({dumped(filled), scope.file.name, pointer});
    } else {
      filler_.refuse(scope, "A step is a command, a batch, a use or a comment.", pointer,
                     "op | commands | use | comment");
    }
  }

  void use(const json& step, const Scope& scope, const std::string& pointer) {
    for (const auto& [name, member] : step.items()) {
      if (name == "use" ? member.is_string() : name == "with" && member.is_object()) continue;
      filler_.refuse(scope, "A use has a name, and \"with\" values for its variables.", pointer + pointer_step(name),
                     "use: text, with: object");
      return;
    }
    const std::string wanted = step["use"].get<std::string>();
    const auto file = scope.file.includes.find(wanted);
    if (file == scope.file.includes.end()) {
      std::vector<std::string_view> known;
      for (const auto& [name, included] : scope.file.includes) known.push_back(name);
      filler_.refuse(scope, "No file that is included is called \"" + wanted + "\".", pointer + "/use",
                     "one of \"include\", without its ending", nearest_name(wanted, known));
      return;
    }
    Scope inner{*file->second, json::object()};
    if (step.contains("with")) inner.given = filler_.fill(step["with"], scope, pointer + "/with");
    if (!filler_.status().ok() || !knows_all(inner, scope, pointer + "/with")) return;
    add_steps(inner);
  }

  /// Whether the file that is used has every variable that is given.
  bool knows_all(const Scope& inner, const Scope& outer, const std::string& pointer) {
    std::vector<std::string_view> known;
    for (const auto& item : inner.file.variables.items()) known.push_back(item.key());
    for (const auto& item : inner.given.items()) {
      if (inner.file.variables.contains(item.key())) continue;
      filler_.refuse(outer, inner.file.name + " has no variable \"" + item.key() + "\".",
                     pointer + pointer_step(item.key()), "one of its \"variables\"", nearest_name(item.key(), known));
      return false;
    }
    return true;
  }

  Filler filler_;
  std::size_t count_ = 0;
  std::vector<RecipeStep> steps_;
};

/// The values that the user sets: JSON where it is that, or a number such as .5, else text.
Status set_variables(const Recipe& recipe, Scope& scope) {
  std::vector<std::string_view> known;
  for (const auto& item : scope.file.variables.items()) known.push_back(item.key());
  for (const auto& [name, text] : recipe.variables) {
    if (!scope.file.variables.contains(name))
      return recipe_failure(recipe.file, "There is no variable \"" + name + "\" to set.",
                            "/variables" + pointer_step(name), "one of \"variables\"", nearest_name(name, known));
    const Result<json> value = parse_json(as_json_number(text));
    scope.given[name] = value ? *value : json(text);
  }
  return {};
}

}  // namespace

bool is_recipe(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos || text[begin] != '{') return false;  // long logs need no parsing for this
  const auto tree = parse_json(text);
  if (!tree || !tree->is_object() || tree->contains("op") || tree->contains("commands")) return false;
  return tree->contains("steps") || tree->contains("variables") || tree->contains("include");
}

Result<std::vector<RecipeStep>> expand_recipe(const Recipe& recipe) {
  RecipeReader reader(recipe);
  const Result<const RecipeFile*> file = reader.read_all();
  if (!file) return file.status();
  Scope scope{**file, json::object()};
  if (Status bad = set_variables(recipe, scope); !bad.ok()) return bad;
  return Expander(recipe).expand(scope);
}

}  // namespace pelage
