#include "renderer/strands/lean_table.h"

#include <algorithm>
#include <cmath>

#include "protocol/base/lean_curve.h"

namespace pelage {

namespace {
constexpr int inclinations = 256;  // between the rows that are kept
}

LeanTable::LeanTable(LeanCurve curve, double root_share) : rows_(inclinations + 1) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const double inclination = static_cast<double>(i) / inclinations;
    for (std::size_t k = 0; k < rows_[i].size(); ++k) {
      const LeanPoint at = lean_point(curve, inclination, root_share, static_cast<double>(k) / lean_cells);
      rows_[i][k] = {glm::vec2(at.across, at.up), glm::vec2(std::sin(at.angle), std::cos(at.angle))};
    }
  }
}

LeanRow LeanTable::row(float inclination) const {
  const float at = std::clamp(inclination, 0.0f, 1.0f) * inclinations;
  const auto low = std::min(static_cast<std::size_t>(at), rows_.size() - 2);
  const float part = at - static_cast<float>(low);
  LeanRow row;
  for (std::size_t k = 0; k < row.size(); ++k) {
    row[k].place = glm::mix(rows_[low][k].place, rows_[low + 1][k].place, part);
    row[k].slope = glm::mix(rows_[low][k].slope, rows_[low + 1][k].slope, part);
  }
  return row;
}

}  // namespace pelage
