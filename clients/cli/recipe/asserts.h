// What a recipe says that its commands have to touch.
#pragma once

#include <nlohmann/json.hpp>

#include "clients/cli/recipe/recipe.h"

namespace pelage::json_parts {

/// Takes {"assert": {"min_vertices": 1, "max_vertices": 900}} from the step, or from each command of its batch. One for
/// each command; none at all where no command has one. Refused (invalid, the pointer within the step) where it is no
/// such thing.
Status take_asserts(nlohmann::json& step, std::vector<std::optional<TouchLimits>>& asserts);

}  // namespace pelage::json_parts
