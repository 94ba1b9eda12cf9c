#include "tests/unit/strands/fur_patch.h"

#include <algorithm>
#include <bit>

namespace pelage {

std::vector<std::vector<std::uint32_t>> sorted_strands(const StrandSet& set) {
  std::vector<std::vector<std::uint32_t>> strands;
  const auto add = [](std::vector<std::uint32_t>& words, float value) {
    words.push_back(std::bit_cast<std::uint32_t>(value));
  };
  for (std::size_t i = 0; i < set.count(); ++i) {
    std::vector<std::uint32_t> words;
    for (int k = 0; k <= set.segments; ++k) {
      const StrandPoint& point = knot(set, i, k);
      for (const float value : {point.position.x, point.position.y, point.position.z, point.radius}) add(words, value);
      words.push_back(set.colours[i * static_cast<std::size_t>(set.segments + 1) + static_cast<std::size_t>(k)]);
    }
    const StrandRoot& root = set.roots[i];
    for (const float value : {root.normal.x, root.normal.y, root.normal.z, root.number, root.reach, root.wetness})
      add(words, value);
    strands.push_back(words);
  }
  std::sort(strands.begin(), strands.end());
  return strands;
}

std::size_t count_shared(const StrandSet& part, const StrandSet& whole) {
  const auto all = sorted_strands(whole);
  const auto some = sorted_strands(part);
  return static_cast<std::size_t>(std::count_if(some.begin(), some.end(), [&](const auto& strand) {
    return std::binary_search(all.begin(), all.end(), strand);
  }));
}

}  // namespace pelage
