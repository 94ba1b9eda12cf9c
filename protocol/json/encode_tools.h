// Commands of the grooming kernel as JSON; decode_tools.h reads them.
#pragma once

#include "protocol/json/encode_parts.h"

namespace pelage::json_parts {

/// Adds the members of a tool; false for commands that are none.
bool add_tool_members(Json& json, const Command& command);

}  // namespace pelage::json_parts
