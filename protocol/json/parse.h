// Parses JSON text to a tree, with refusals that the library itself does not make.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "base/status.h"

namespace pelage {

/// Refuses (malformed) text that is not JSON, duplicate keys (with their pointer), more than 32 levels and numbers
/// that overflow a double.
Result<nlohmann::json> parse_json(std::string_view text);

/// Converts a number such as ".5", "5." or "+1" to JSON's form; returns any other text as it is.
std::string as_json_number(std::string_view text);

/// Returns `key` as one step of a JSON pointer (RFC 6901).
std::string pointer_step(std::string_view key);

}  // namespace pelage
