// The asserts of a recipe: how many vertices its commands have to touch.
#pragma once

#include <nlohmann/json.hpp>

#include "base/status.h"
#include "protocol/commands/recipe.h"

namespace pelage::json_parts {

/// Removes {"assert": {"min_vertices": 1, "max_vertices": 900}} from the step, or from each command of its batch, and
/// returns the limits. Refuses (invalid, the pointer within the step) a malformed assert.
Result<std::vector<TouchLimits>> take_asserts(nlohmann::json& step);

}  // namespace pelage::json_parts
