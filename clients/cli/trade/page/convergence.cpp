#include <fmt/format.h>

#include "clients/cli/trade/page/front.h"
#include "clients/cli/trade/page/plots.h"
#include "clients/cli/trade/page/svg.h"

namespace pelage::trade {

namespace {

struct Curve {
  std::string scene;
  std::vector<double> shells = {}, errors = {};
};

Curve curve_of(const std::vector<Row>& rows, const std::string& scene) {
  Curve curve{.scene = scene};
  for (const Row& row : rows) {
    const bool wanted =
        row.scene == scene && row.series == "shells" && row.base == "interactive" && against_shells(row);
    if (!wanted || !(row.flip > 0)) continue;
    curve.shells.push_back(row.shells), curve.errors.push_back(row.flip);
  }
  return curve;
}

std::string draw(const Axes& axes, const Curve& curve, std::size_t n) {
  std::vector<std::pair<double, double>> line;
  std::string marks;
  for (std::size_t i = 0; i < curve.shells.size(); ++i) {
    line.emplace_back(axes.to_x(curve.shells[i]), axes.to_y(curve.errors[i]));
    marks += dot(line.back().first, line.back().second, 3.5, colour(n),
                 fmt::format("{}: {} shells, FLIP {:.4f}", curve.scene, curve.shells[i], curve.errors[i]));
  }
  const auto order = fitted_order(curve.shells, curve.errors);
  const double y = axes.top + 14 + 18 * static_cast<double>(n), x = axes.left + axes.width + 18;
  const std::string fit = order ? fmt::format("{}: order {:.2f}", curve.scene, *order) : curve.scene;
  return polyline(line, colour(n), 1.8, n >= 7) + marks + dot(x, y - 4, 4, colour(n), "") + label(x + 10, y, fit);
}

}  // namespace

std::string convergence_plot(const std::vector<Row>& rows) {
  std::vector<Curve> curves;
  std::vector<double> shells, errors;
  for (const std::string& scene : all_scenes(rows)) {
    curves.push_back(curve_of(rows, scene));
    shells.insert(shells.end(), curves.back().shells.begin(), curves.back().shells.end());
    errors.insert(errors.end(), curves.back().errors.begin(), curves.back().errors.end());
  }
  const Axes axes{.width = 480, .height = 330, .x = span_of(shells), .y = span_of(errors)};
  std::string content = axes_svg(axes, "shells", "error (masked FLIP)");
  for (std::size_t n = 0; n < curves.size(); ++n) content += draw(axes, curves[n], n);
  return svg(1000, 400, "Error against shells", content);
}

}  // namespace pelage::trade
