// Files of named places: {"left_ear": [0.62, 0.98, 0.71], ...}, shares of the model's box.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "base/status.h"

namespace pelage {

/// The file's text with this place added or put in the place of the one of its name; one line each. Refused (malformed
/// or invalid) where the text is no such file. "" stands for a new file.
Result<std::string> with_place(std::string_view text, const std::string& name, const std::array<double, 3>& shares);

}  // namespace pelage
