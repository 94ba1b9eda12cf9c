// Helping with typing mistakes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pelage {

/// The word among `known` with the smallest edit distance to `word` (its first 80 bytes), the first of several.
std::string nearest_name(std::string_view word, const std::vector<std::string_view>& known);

}  // namespace pelage
