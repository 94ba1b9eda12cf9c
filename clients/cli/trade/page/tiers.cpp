#include <fmt/format.h>

#include "clients/cli/trade/page/front.h"
#include "clients/cli/trade/page/plots.h"
#include "clients/cli/trade/page/svg.h"

namespace pelage::trade {

namespace {

constexpr double row_height = 26;

std::string key(double y) {
  std::string text;
  double x = 400;
  for (const char* tier : {"draft", "interactive", "detailed"}) {
    text += dot(x, y - 4, 6, tier_colour(tier), "") + label(x + 11, y, tier, "start", tier_colour(tier));
    x += 110;
  }
  return text + dot(x, y - 4, 5, "#555", "", true) + label(x + 11, y, "hollow: in the outline");
}

std::string marks_of(const Axes& axes, const Row& row, double y) {
  const std::string hint =
      fmt::format("{}, {}: FLIP {:.4f}, outline {:.4f}", row.scene, row.value, row.flip, row.outline);
  std::string text;
  if (row.outline > 0) text += dot(axes.to_x(row.outline), y, 5, tier_colour(row.value), hint, true);
  return text + dot(axes.to_x(row.flip), y, 6, tier_colour(row.value), hint);
}

}  // namespace

std::string tier_plot(const std::vector<Row>& rows) {
  const std::vector<std::string> scenes = all_scenes(rows);
  std::vector<double> errors;
  for (const Row& row : rows) {
    if (row.series == "tier" && against_shells(row)) errors.push_back(row.flip), errors.push_back(row.outline);
  }
  const Span no_ticks{2.1, 4.9};  // scenes have no scale
  const double height = row_height * static_cast<double>(scenes.size());
  const Axes axes{.left = 390, .top = 34, .width = 540, .height = height, .x = span_of(errors), .y = no_ticks};
  std::string content = key(16) + axes_svg(axes, "error (masked FLIP), less is better", "");
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const double y = axes.top + row_height * (static_cast<double>(i) + 0.5);
    content += label(axes.left - 12, y + 4, scenes[i], "end");
    for (const Row& row : rows) {
      if (row.scene == scenes[i] && row.series == "tier" && against_shells(row)) content += marks_of(axes, row, y);
    }
  }
  return svg(960, axes.top + axes.height + 50, "Where the tiers lie", content);
}

}  // namespace pelage::trade
