#include "clients/cli/trade/page/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pelage::trade {

namespace {

/// Where a value lies in a span, 0 to 1 on a logarithmic scale.
double share(const Span& span, double value) {
  const double held = std::clamp(value, span.least, span.largest);
  return std::log(held / span.least) / std::log(span.largest / span.least);
}

/// At 1, 2 and 5 of every decade, or at 1 alone where `pixels` leave no room for their numbers.
std::vector<double> ticks_of(const Span& span, double pixels, double room) {
  std::vector<double> ticks;
  const bool dense = pixels / std::log10(span.largest / span.least) > 3 * room;
  for (double decade = std::pow(10, std::floor(std::log10(span.least))); decade <= span.largest; decade *= 10) {
    for (const double step : {1.0, 2.0, 5.0}) {
      const double tick = decade * step;
      if ((dense || step == 1) && tick >= span.least * 0.999 && tick <= span.largest * 1.001) ticks.push_back(tick);
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
  double least = INFINITY, largest = 0;
  for (const double value : values) {
    if (!(value > 0) || !std::isfinite(value)) continue;
    least = std::min(least, value), largest = std::max(largest, value);
  }
  if (largest == 0) return {};
  const double middle = std::sqrt(least * largest);
  return {std::min(least / 1.15, middle / 1.5), std::max(largest * 1.15, middle * 1.5)};
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
