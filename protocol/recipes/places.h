// Named places and sizes: {"left_ear": [0.62, 0.98, 0.71], "ear_size": 0.06}.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "base/status.h"

namespace pelage::json_parts {

/// Returns whether the value is a list of three numbers.
bool is_triple(const nlohmann::json& value);

/// Refuses (invalid) anything but an object of places (three shares of the model's box) and sizes (numbers). `pointer`
/// leads to the object.
Status check_places(const nlohmann::json& places, const std::string& pointer);

}  // namespace pelage::json_parts
