// The small parts that plots are drawn of: texts, marks, and axes with logarithmic scales. All of it is well-formed
// XML.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "clients/cli/trade/page/row.h"

namespace pelage::trade {

/// Text for XML, safe within quotes too.
std::string escaped(std::string_view text);

/// A colour-blind safe colour (Okabe and Ito 2008) for the n-th of a few things; goes round.
const char* colour(std::size_t n);

/// Blue, orange and green of the tiers, grey of anything else.
const char* tier_colour(std::string_view tier);

/// Least and largest of what an axis shows; both above 0.
struct Span {
  double min = 0.1, max = 1;
};

/// The span of these values, a little wider, at least a factor of 2; values that are not above 0 are passed over.
Span span_of(const std::vector<double>& values);

/// The area of a plot in pixels, and what it shows.
struct Axes {
  double left = 64, top = 16, width = 500, height = 300;
  Span x = {}, y = {};

  double to_x(double value) const;  // held to the area
  double to_y(double value) const;
};

/// Lines, ticks at 1, 2 and 5 of every decade, and titles.
std::string axes_svg(const Axes& axes, std::string_view x_title, std::string_view y_title);

/// A dot that says `hint` when the pointer rests on it.
std::string dot(double x, double y, double radius, const char* fill, std::string_view hint, bool hollow = false);

/// `anchor`: start, middle or end.
std::string label(double x, double y, std::string_view text, const char* anchor = "start", const char* fill = "#333");

/// A line through points of the plot, in pixels.
std::string polyline(const std::vector<std::pair<double, double>>& points, const char* stroke, double width,
                     bool dashed = false);

/// An svg of this size around what is in it; `title` is what a screen reader says.
std::string svg(double width, double height, std::string_view title, const std::string& content);

}  // namespace pelage::trade

// The plots of the report, each an svg. Rows that are not against R1 are passed over.

namespace pelage::trade {

/// Error against cost of every setting on one scene, with the Pareto front and the tiers (scatter.cpp).
std::string scatter_plot(const std::vector<Row>& rows, const std::string& scene);

/// One small plot for each knob: the way that turning it takes through error and cost on one scene (multiples.cpp).
std::string knob_plots(const std::vector<Row>& rows, const std::string& scene);

/// Where the tiers' errors lie on every scene, over the fur and in its silhouette (tiers.cpp).
std::string tier_plot(const std::vector<Row>& rows);

/// Error against the number of shells on every scene, with fitted slopes (convergence.cpp).
std::string convergence_plot(const std::vector<Row>& rows);

}  // namespace pelage::trade
