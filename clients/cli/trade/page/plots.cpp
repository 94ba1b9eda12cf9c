#include "clients/cli/trade/page/plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "clients/cli/trade/page/page.h"

namespace pelage::trade {

namespace {

/// Where a value lies in a span, 0 to 1 on a logarithmic scale.
double share(const Span& span, double value) {
  const double held = std::clamp(value, span.min, span.max);
  return std::log(held / span.min) / std::log(span.max / span.min);
}

/// At 1, 2 and 5 of every decade, or at 1 alone where `pixels` leave no room for their numbers.
std::vector<double> ticks_of(const Span& span, double pixels, double room) {
  std::vector<double> ticks;
  const bool dense = pixels / std::log10(span.max / span.min) > 3 * room;
  for (double decade = std::pow(10, std::floor(std::log10(span.min))); decade <= span.max; decade *= 10) {
    for (const double step : {1.0, 2.0, 5.0}) {
      const double tick = decade * step;
      if ((dense || step == 1) && tick >= span.min * 0.999 && tick <= span.max * 1.001) ticks.push_back(tick);
    }
  }
  return ticks;
}

std::string line(double x1, double y1, double x2, double y2, const char* stroke) {
  return fmt::format(R"(<line x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}" stroke="{}"/>)", x1, y1, x2, y2, stroke);
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '&': result += "&amp;"; break;
      case '"': result += "&quot;"; break;
      // XML has no other control characters.
      default: result += static_cast<unsigned char>(c) < 32 && c != '\n' && c != '\t' ? ' ' : c;
    }
  }
  return result;
}

const char* colour(std::size_t n) {
  static constexpr std::array<const char*, 7> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                      "#e69f00", "#56b4e9", "#555555"};
  return colours[n % colours.size()];
}

const char* tier_colour(std::string_view tier) {
  if (tier == "draft") return colour(0);
  if (tier == "interactive") return colour(1);
  return tier == "detailed" ? colour(2) : "#888";
}

Span span_of(const std::vector<double>& values) {
  double min = INFINITY, largest = 0;
  for (const double value : values) {
    if (!(value > 0) || !std::isfinite(value)) continue;
    min = std::min(min, value), largest = std::max(largest, value);
  }
  if (largest == 0) return {};
  const double middle = std::sqrt(min * largest);
  return {std::min(min / 1.15, middle / 1.5), std::max(largest * 1.15, middle * 1.5)};
}

double Axes::to_x(double value) const { return left + width * share(x, value); }
double Axes::to_y(double value) const { return top + height * (1 - share(y, value)); }

std::string axes_svg(const Axes& axes, std::string_view x_title, std::string_view y_title) {
  const double bottom = axes.top + axes.height, right = axes.left + axes.width;
  std::string text;
  for (const double tick : ticks_of(axes.x, axes.width, 30)) {
    text += line(axes.to_x(tick), axes.top, axes.to_x(tick), bottom, "#e8e4de");
    text += label(axes.to_x(tick), bottom + 16, fmt::format("{:.4g}", tick), "middle", "#666");
  }
  for (const double tick : ticks_of(axes.y, axes.height, 14)) {
    text += line(axes.left, axes.to_y(tick), right, axes.to_y(tick), "#e8e4de");
    text += label(axes.left - 6, axes.to_y(tick) + 4, fmt::format("{:.4g}", tick), "end", "#666");
  }
  text += line(axes.left, bottom, right, bottom, "#888") + line(axes.left, axes.top, axes.left, bottom, "#888");
  if (!x_title.empty()) text += label(axes.left + axes.width / 2, bottom + 36, x_title, "middle");
  if (y_title.empty()) return text;
  return text +
         fmt::format(R"svg(<text transform="translate({:.1f} {:.1f}) rotate(-90)" text-anchor="middle">{}</text>)svg",
                     axes.left - 46, axes.top + axes.height / 2, escaped(y_title));
}

std::string dot(double x, double y, double radius, const char* fill, std::string_view hint, bool hollow) {
  return fmt::format(
      R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}" fill="{}" stroke="{}" stroke-width="1.5"><title>{}</title></circle>)",
      x, y, radius, hollow ? "#fff" : fill, hollow ? fill : "none", escaped(hint));
}

std::string label(double x, double y, std::string_view text, const char* anchor, const char* fill) {
  return fmt::format(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="{}" fill="{}">{}</text>)", x, y, anchor, fill,
                     escaped(text));
}

std::string polyline(const std::vector<std::pair<double, double>>& points, const char* stroke, double width,
                     bool dashed) {
  std::string places;
  for (const auto& [x, y] : points) places += fmt::format("{}{:.1f},{:.1f}", places.empty() ? "" : " ", x, y);
  return fmt::format(R"(<polyline points="{}" fill="none" stroke="{}" stroke-width="{}"{}/>)", places, stroke, width,
                     dashed ? R"( stroke-dasharray="5 4")" : "");
}

std::string svg(double width, double height, std::string_view title, const std::string& content) {
  return fmt::format(R"(<svg width="{0:.0f}" height="{1:.0f}" viewBox="0 0 {0:.0f} {1:.0f}" role="img" )"
                     R"(font-size="12" font-family="sans-serif"><title>{2}</title>{3}</svg>)",
                     width, height, escaped(title), content);
}

}  // namespace pelage::trade

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
  return fmt::format("{}: {} ms, FLIP {:.4f}, silhouette {:.4f}", name_of(row), milliseconds(cost_of(row)), row.flip,
                     row.silhouette);
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
