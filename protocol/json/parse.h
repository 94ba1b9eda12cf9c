// JSON text to a tree, with the refusals that the parser itself does not make.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "base/status.h"

namespace pelage {

/// Refuses (malformed) text that is not JSON, duplicate keys (with their pointer), more than 32 levels and numbers
/// that overflow a double.
Result<nlohmann::json> parse_json(std::string_view text);

/// How JSON writes a number that people write as ".5", "5." or "+1". Any other text comes back as it is.
std::string as_json_number(std::string_view text);

/// `key` as one step of a JSON pointer (RFC 6901).
std::string pointer_step(std::string_view key);

}  // namespace pelage
