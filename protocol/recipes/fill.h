// Fills in the variables, expressions and places of a recipe's steps.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "base/status.h"
#include "protocol/commands/answers.h"
#include "protocol/recipes/recipe_files.h"

namespace pelage::json_parts {

/// The values of a file's variables in one use of it.
struct Scope {
  const RecipeFile& file;
  nlohmann::json given = nlohmann::json::object();  // values for this use, loop variables and picks; all filled in
};

std::string dumped(const nlohmann::json& value);

/// Copies values with variables and places filled in; places are shares of `box`. Keeps the first refusal; after it
/// copies are empty.
class Filler {
 public:
  explicit Filler(const Bounds& box) : box_(box) {}

  const Status& status() const { return status_; }

  nlohmann::json fill(const nlohmann::json& value, const Scope& scope, const std::string& pointer);
  /// Refuses what stands at the pointer within the scope's file.
  nlohmann::json refuse(const Scope& scope, const std::string& message, const std::string& pointer, std::string limit,
                        std::string nearest = {});
  /// The same with the refusal of the scene or the decoder.
  void refuse(const Scope& scope, const std::string& pointer, const Status& why);

  /// Converts shares of the box to model coordinates, and back.
  nlohmann::json position_at(const nlohmann::json& shares) const;
  nlohmann::json shares_of(const nlohmann::json& position) const;

 private:
  nlohmann::json fill_text(const std::string& text, const Scope& scope, const std::string& pointer);
  nlohmann::json variable_or_expression(const std::string& text, const Scope& scope, const std::string& pointer);
  nlohmann::json variable(const std::string& name, const Scope& scope, const std::string& pointer);
  nlohmann::json expression(const std::string& text, const Scope& scope, const std::string& pointer);
  nlohmann::json count(const nlohmann::json& value, const Scope& scope, const std::string& pointer);
  bool within_value_limit(const Scope& scope, const std::string& pointer);
  nlohmann::json place(const nlohmann::json& place, const Scope& scope, const std::string& pointer);

  const Bounds box_;
  std::size_t values_ = 0;
  int depth_ = 0;
  Status status_;
};

}  // namespace pelage::json_parts
