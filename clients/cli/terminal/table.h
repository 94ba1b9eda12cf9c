// Columns of text that line up.
#pragma once

#include <string>
#include <vector>

namespace pelage {

/// A line for each row, the first being the heads; columns are as wide as their widest cell. Numbers, which are cells
/// of digits alone, stand at the right.
std::string table_of(const std::vector<std::vector<std::string>>& rows);

}  // namespace pelage
