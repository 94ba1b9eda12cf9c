// Files of commands, split into steps.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"

namespace pelage {

/// The texts of a file of commands, each one undo step: JSON lines, an array, or one document over many lines.
/// Malformed texts are refused with the number of their line or element in the message.
Result<std::vector<std::string>> split_steps(std::string_view text);

}  // namespace pelage
