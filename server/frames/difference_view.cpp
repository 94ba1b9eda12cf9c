#include "server/frames/difference_view.h"

#include <algorithm>
#include <limits>

namespace pelage {

namespace {

/// The change that counts as much.
double full_change(Field field, const FieldSet& from, const FieldSet& to) {
  const FieldShape& shape = shape_of(field);
  if (field != Field::length) return shape.channels > 1 ? 1 : double{shape.max} - double{shape.min};
  float longest = std::numeric_limits<float>::min();
  for (const FieldSet* fields : {&from, &to}) {
    for (const float length : fields->length()) longest = std::max(longest, length);
  }
  return longest;
}

}  // namespace

std::vector<float> change_shares(const FieldSet& from, const FieldSet& to) {
  std::vector<float> shares(to.size(), 0.0f);
  for (std::size_t f = 0; f < field_count; ++f) {
    const Field field = field_at(f);
    if (from.at_default(field) && to.at_default(field)) continue;
    const double full = full_change(field, from, to);
    for (std::uint32_t v = 0; v < shares.size(); ++v) {
      const glm::vec4 before = from.value(field, v), after = to.value(field, v);
      if (before == after) continue;
      const double share = glm::length(glm::dvec4(after) - glm::dvec4(before)) / full;
      // The least share that shows: a change is never drawn as none.
      shares[v] = std::max(shares[v], static_cast<float>(std::clamp(share, 1e-6, 1.0)));
    }
  }
  return shares;
}

}  // namespace pelage
