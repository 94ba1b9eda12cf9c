// Files of named places, {"left_ear": [0.62, 0.98, 0.71], ...}: positions as fractions of the model's bounding box.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "base/status.h"

namespace pelage {

/// Returns the file's text with the place added, or replaced if the name exists, one place in each line. Fails
/// (malformed or invalid) if `text` is not such a file; "" stands for a new file.
Result<std::string> with_place(std::string_view text, const std::string& name, const std::array<double, 3>& shares);

}  // namespace pelage
