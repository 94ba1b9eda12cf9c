// What a recipe says that its commands have to touch.
#pragma once

#include <nlohmann/json.hpp>

#include "base/status.h"
#include "protocol/commands/recipe.h"

namespace pelage::json_parts {

/// Takes {"assert": {"min_vertices": 1, "max_vertices": 900}} from the step, or from each command of its batch. Refused
/// (invalid, the pointer within the step) where it is no such thing.
Result<std::vector<TouchLimits>> take_asserts(nlohmann::json& step);

}  // namespace pelage::json_parts
