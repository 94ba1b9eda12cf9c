#include "protocol/json/nearest.h"

#include <algorithm>
#include <numeric>

namespace pelage {

namespace {

constexpr std::size_t compared_bytes = 80;

/// Levenshtein distance, one row at a time.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t k = 1; k <= b.size(); ++k) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[k - 1] ? 0 : 1);
      diagonal = row[k];
      row[k] = std::min({row[k] + 1, row[k - 1] + 1, substituted});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_name(std::string_view word, const std::vector<std::string_view>& known) {
  const std::string_view compared = word.substr(0, compared_bytes);
  std::string_view best;
  std::size_t min = std::string_view::npos;
  for (const std::string_view name : known) {
    const std::size_t distance = edit_distance(compared, name);
    if (distance < min) {
      min = distance;
      best = name;
    }
  }
  return std::string(best);
}

}  // namespace pelage
