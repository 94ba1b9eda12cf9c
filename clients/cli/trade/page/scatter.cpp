#include <fmt/format.h>

#include <set>

#include "clients/cli/trade/page/front.h"
#include "clients/cli/trade/page/plots.h"
#include "clients/cli/trade/page/svg.h"

namespace pelage::trade {

namespace {

/// Each setting once: a frame belongs to several series. The tier's own row goes first.
std::vector<Row> points_of(const std::vector<Row>& rows, const std::string& scene) {
  std::vector<Row> points;
  std::set<std::string> seen;
  for (const bool tiers : {true, false}) {
    for (const Row& row : rows) {
      const bool wanted = row.scene == scene && against_shells(row) && (row.series == "tier") == tiers;
      if (wanted && seen.insert(row.knobs).second) points.push_back(row);
    }
  }
  return points;
}

std::string hint_of(const Row& row) {
  return fmt::format("{}: {} ms, FLIP {:.4f}, outline {:.4f}", name_of(row), milliseconds(cost_of(row)), row.flip,
                     row.outline);
}

std::string front_line(const Axes& axes, const std::vector<double>& costs, const std::vector<double>& errors) {
  std::vector<std::pair<double, double>> line;
  for (const std::size_t i : pareto_front(costs, errors)) line.emplace_back(axes.to_x(costs[i]), axes.to_y(errors[i]));
  return polyline(line, "#b08d57", 2);
}

}  // namespace

std::string scatter_plot(const std::vector<Row>& rows, const std::string& scene) {
  const std::vector<Row> points = points_of(rows, scene);
  std::vector<double> costs, errors;
  for (const Row& row : points) costs.push_back(cost_of(row)), errors.push_back(row.flip);
  const Axes axes{.top = 28, .width = 440, .height = 300, .x = span_of(costs), .y = span_of(errors)};
  std::string content = axes_svg(axes, "drawing, milliseconds", "error (masked FLIP)");
  content += front_line(axes, costs, errors);
  std::string tiers;  // last, so that nothing hides them
  for (const Row& row : points) {
    const double x = axes.to_x(cost_of(row)), y = axes.to_y(row.flip);
    if (row.series == "tier")
      tiers += dot(x, y, 7, tier_colour(row.value), hint_of(row)) +
               label(x, y - 12, row.value, "middle", tier_colour(row.value));
    else
      content += dot(x, y, 3.2, "#9a948a", hint_of(row));
  }
  return svg(540, 380, "Error against cost: " + scene, content + tiers);
}

}  // namespace pelage::trade
