#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "clients/cli/trade/page/front.h"
#include "clients/cli/trade/page/plots.h"
#include "clients/cli/trade/page/svg.h"

namespace pelage::trade {

namespace {

constexpr double width = 300, height = 220;

using Points = std::vector<const Row*>;

std::vector<std::string> knobs_in(const Points& points) {
  std::vector<std::string> knobs;
  for (const Row* row : points) {
    const bool knob = row->series != "tier" && row->series != "grid";
    if (knob && std::find(knobs.begin(), knobs.end(), row->series) == knobs.end()) knobs.push_back(row->series);
  }
  return knobs;
}

/// Whether a number at `place` would run into those that are written already.
bool is_free(const std::vector<std::pair<double, double>>& written, std::pair<double, double> place) {
  return std::none_of(written.begin(), written.end(), [&](const auto& other) {
    return std::abs(other.first - place.first) < 24 && std::abs(other.second - place.second) < 12;
  });
}

/// The way of one knob around one tier, with its values where there is room.
std::string way_of(const Axes& axes, const Points& points, const std::string& knob, const std::string& base) {
  std::vector<std::pair<double, double>> line, written;
  std::string marks;
  for (const Row* row : points) {
    if (row->series != knob || row->base != base) continue;
    const double x = axes.to_x(cost_of(*row)), y = axes.to_y(row->flip);
    line.emplace_back(x, y);
    const std::string hint =
        fmt::format("{}: {} ms, FLIP {:.4f}", name_of(*row), milliseconds(cost_of(*row)), row->flip);
    marks += dot(x, y, 4, tier_colour(base), hint);
    for (const double below : {-5.0, 15.0}) {
      if (!is_free(written, {x, y + below})) continue;
      marks += label(x + 6, y + below, row->value, "start", tier_colour(base));
      written.emplace_back(x, y + below);
      break;
    }
  }
  return line.empty() ? "" : polyline(line, tier_colour(base), 2) + marks;
}

std::string panel(Axes axes, const Points& points, const std::string& knob) {
  std::string content = label(axes.left, 14, knob, "start", "#222");
  axes.top = 24;
  content += axes_svg(axes, "ms", "error");
  for (const Row* row : points) content += dot(axes.to_x(cost_of(*row)), axes.to_y(row->flip), 1.6, "#d6d0c6", "");
  for (const char* base : {"draft", "interactive", "detailed"}) content += way_of(axes, points, knob, base);
  return svg(width, height, "What " + knob + " buys", content);
}

}  // namespace

std::string knob_plots(const std::vector<Row>& rows, const std::string& scene) {
  Points points;
  std::vector<double> costs, errors;
  for (const Row& row : rows) {
    if (row.scene != scene || !against_shells(row)) continue;
    points.push_back(&row);
    costs.push_back(cost_of(row)), errors.push_back(row.flip);
  }
  const Axes axes{.left = 56, .width = width - 84, .height = height - 70, .x = span_of(costs), .y = span_of(errors)};
  std::string panels;
  for (const std::string& knob : knobs_in(points)) panels += panel(axes, points, knob);
  return "<div class=\"panels\">" + panels + "</div>";
}

}  // namespace pelage::trade
