// What frames of rasterized strands cost and how far they are from the truth, estimated from a view without drawing it.
#pragma once

#include <array>
#include <vector>

#include "protocol/commands/quality.h"
#include "renderer/quality/view_features.h"

namespace pelage {

inline constexpr std::size_t cost_terms = 7;

/// Knobs that a planner may choose, and their error: that of a view where the fur is one pixel long, times its length
/// in pixels to the power of `growth`.
struct DialRow {
  Knobs knobs;
  double error = 0;   // median of the mean FLIP of views, above 0
  double growth = 0;  // of the error with the fur's length
  double safety = 1;  // 95% of views have at most the error times it, 1 or more
};

/// Prices are milliseconds of one thread of the machine that the defaults were measured on.
struct DialModel {
  std::array<double, cost_terms> prices{};  // of cost_terms_of, 0 or more
  double cost_safety = 1;                   // 1 or more, of a scene of which nothing is learnt yet
  double learnt_safety = 1;                 // 1 or more, once they have
  double min_fur = 1, max_fur = 1;          // pixels, of the views that were measured; outside, the nearest counts
  std::vector<DialRow> rows;                // one to eight
};

/// Returns the model that tests/bench/dial.cpp writes.
const DialModel& default_model();

/// The tier `interactive` but for these: what rows differ in.
Knobs dial_knobs(double strands, int light_of, double scale);

/// A frame; millions of pixels; a hundred thousand strands that are seen, that are kept of them, and that are lit by
/// each light; millions of pixels that the kept ones cover; a hundred thousand pixels of furred skin.
std::array<double, cost_terms> cost_terms_of(const ViewFeatures& view, const Knobs& knobs);

/// Returns the cost by the default prices: milliseconds above 0, without what eyes, curves and the ground add, and what
/// grows anew. For shells, which no planner chooses, it is a guess.
double predicted_cost(const DialModel& model, const ViewFeatures& view, const Knobs& knobs);

/// Returns the median of the mean FLIP of views like this, (0, 1].
double predicted_error(const DialModel& model, const DialRow& row, const ViewFeatures& view);

}  // namespace pelage
