// From the steps of a recipe, which may be loops, picks and uses of other files, to the steps that are sent.
#pragma once

#include <vector>

#include "protocol/recipes/fill.h"
#include "protocol/recipes/recipe.h"

namespace pelage::json_parts {

/// Goes through the steps of a file and of those that it uses, in their order. Picks are made as they come.
class Expander {
 public:
  /// `places` by their names, as shares of the box.
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
  /// Refuses members of a step that are not of these names and types.
  bool has_only(const nlohmann::json& step, const std::map<std::string, nlohmann::json::value_t>& known,
                const std::string& message, const Scope& scope, const std::string& pointer);

  const RecipeScene& scene_;
  const nlohmann::json& places_;
  Filler filler_;
  std::size_t count_ = 0, picks_ = 0;
  int uses_ = 0;  // that are open
  std::vector<FilledStep> steps_;
};

}  // namespace pelage::json_parts
