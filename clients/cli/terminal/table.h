// Formats rows of text as aligned columns.
#pragma once

#include <string>
#include <vector>

namespace pelage {

/// Returns one line for each row; the first row holds the headings. Columns are as wide as their widest cell. Cells
/// with only digits are right-aligned.
std::string table_of(const std::vector<std::vector<std::string>>& rows);

}  // namespace pelage
