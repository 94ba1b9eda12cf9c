// The parser for files of named places and sizes.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "base/status.h"

namespace pelage::json_parts {

/// The places and sizes of a file by their names: three shares of the box, or a number; none of "".
Result<nlohmann::json> read_places(std::string_view text);

}  // namespace pelage::json_parts
