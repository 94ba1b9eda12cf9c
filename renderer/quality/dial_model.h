// Predicts the cost of frames of rasterized strands and their error from a view, without drawing it.
#pragma once

#include <array>
#include <vector>

#include "protocol/commands/quality.h"
#include "renderer/quality/view_features.h"

namespace pelage {

inline constexpr std::size_t cost_terms = 7;

/// Knobs that a planner may choose, with their predicted error: that of a view whose fur is one pixel long, times the
/// fur's length in pixels to the power of `growth`.
struct DialRow {
  Knobs knobs;
  double error = 0;   // median of the mean FLIP of views, above 0
  double growth = 0;  // exponent of the fur's length in the error
  double safety = 1;  // factor on the error that covers 95% of views, at least 1
};

/// Costs and errors of all rows. Coefficients are milliseconds of one thread of the machine that the defaults were
/// measured on.
struct DialModel {
  std::array<double, cost_terms> coefficients{};  // for each of cost_terms_of, at least 0
  double cost_safety = 1;           // factor on the cost of a scene without a learnt correction, at least 1
  double learnt_safety = 1;         // the same for a scene with a learnt correction, at least 1
  double min_fur = 1, max_fur = 1;  // range of fur lengths that were measured, pixels; others are clamped to it
  std::vector<DialRow> rows;        // one to eight
};

/// Returns the model that tests/bench/dial.cpp writes.
const DialModel& default_model();

/// Returns the knobs of the tier `interactive` with these values, in which rows differ.
Knobs dial_knobs(double strands, int light_of, double scale);

/// Returns the terms of the cost: 1 for the frame; millions of pixels; hundreds of thousands of strands in view, of
/// those that are drawn, and of those that are lit, for each light; millions of pixels that drawn strands cover;
/// hundreds of thousands of pixels of furred skin.
std::array<double, cost_terms> cost_terms_of(const ViewFeatures& view, const Knobs& knobs);

/// Returns the cost by the model's coefficients in milliseconds, above 0, without eyes, curves, the ground and the
/// growing of strands. For shells, which no planner chooses, it is a guess.
double predicted_cost(const DialModel& model, const ViewFeatures& view, const Knobs& knobs);

/// Returns the median of the mean FLIP of such views, (0, 1].
double predicted_error(const DialModel& model, const DialRow& row, const ViewFeatures& view);

}  // namespace pelage
