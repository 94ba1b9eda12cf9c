// Expands the steps of a recipe, which may be loops, picks and uses of other files, to the steps that are sent.
#pragma once

#include <vector>

#include "protocol/recipes/fill.h"
#include "protocol/recipes/recipe.h"

namespace pelage::json_parts {

/// Expands the steps of a file and of the files that it uses, in order. Picks are made as they come.
class Expander {
 public:
  /// `places`: positions by name, as shares of the model's box, and sizes by name.
  Expander(const RecipeScene& scene, const nlohmann::json& places)
      : scene_(scene), places_(places), filler_(scene.box) {}

  Result<std::vector<FilledStep>> expand(Scope& scope);

 private:
  void add_steps(const nlohmann::json& steps, Scope& scope, const std::string& pointer);
  void add_step(const nlohmann::json& step, Scope& scope, const std::string& pointer);
  void add_commands(const nlohmann::json& step, const Scope& scope, const std::string& pointer);
  void loop(const nlohmann::json& step, Scope& scope, const std::string& pointer);
  void run_loop(const nlohmann::json& lists, const nlohmann::json& steps, Scope& scope, const std::string& pointer);
  void pick(const nlohmann::json& step, Scope& scope, const std::string& pointer);
  Result<nlohmann::json> picked(const nlohmann::json& request);
  void use(const nlohmann::json& step, Scope& scope, const std::string& pointer);
  bool knows_all(const Scope& inner, const Scope& outer, const std::string& pointer);
  /// Returns whether the step has just these members, of these types (a comment is allowed); refuses it otherwise.
  bool has_only(const nlohmann::json& step, const std::map<std::string, nlohmann::json::value_t>& known,
                const std::string& message, const Scope& scope, const std::string& pointer);

  const RecipeScene& scene_;
  const nlohmann::json& places_;
  Filler filler_;
  std::size_t count_ = 0, picks_ = 0;
  int uses_ = 0;  // depth of nested uses
  std::vector<FilledStep> steps_;
};

}  // namespace pelage::json_parts
