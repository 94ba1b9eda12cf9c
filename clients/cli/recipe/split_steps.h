// Splits files of commands into steps.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"

namespace pelage {

/// Returns the JSON text of each undo step in a file of commands, which is JSON lines, an array, or one document over
/// many lines. Fails on malformed JSON; the message has the number of the line or element.
Result<std::vector<std::string>> split_steps(std::string_view text);

}  // namespace pelage
