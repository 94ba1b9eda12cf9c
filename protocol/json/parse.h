// JSON text to a tree, with the refusals that the parser itself does not make.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "protocol/base/status.h"

namespace pelage {

/// Refuses (malformed) text that is not JSON, duplicate keys (with their pointer), more than 32 levels and numbers
/// that overflow a double.
Result<nlohmann::json> parse_json(std::string_view text);

/// `key` as one step of a JSON pointer (RFC 6901).
std::string pointer_step(std::string_view key);

}  // namespace pelage
