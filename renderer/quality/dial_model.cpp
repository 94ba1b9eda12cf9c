#include "renderer/quality/dial_model.h"

#include <algorithm>
#include <cmath>

namespace pelage {

Knobs dial_knobs(int shells, int steps, double scale) {
  Knobs knobs = knobs_of(Tier::interactive);
  knobs.shells = shells, knobs.steps = steps, knobs.scale = scale;
  return knobs;
}

std::array<double, cost_terms> cost_terms_of(const ViewFeatures& view, const Knobs& knobs) {
  constexpr double million = 1e6, hundred_thousand = 1e5;
  const double segments = view.area * knobs.scale * knobs.scale * knobs.shells / million;
  return {view.pixels / million, segments, segments * view.lights, segments * knobs.steps,
          view.triangles * knobs.shells / hundred_thousand};
}

namespace {

/// Of pixels, and of strands that are kept, of which the drawing is half and the light of one the rest.
double raster_cost(const ViewFeatures& view, const Knobs& knobs) {
  constexpr double million_pixels = 60, strand = 6e-4, light = 6e-4;  // milliseconds
  const double scale = knobs.scale * knobs.scale;
  const double kept = std::min(view.strands, 1.3 * knobs.raster.strands * view.area * scale);
  return million_pixels * view.pixels * scale / 1e6 + kept * (strand + light / knobs.raster.light_of);
}

}  // namespace

double predicted_cost(const DialModel& model, const ViewFeatures& view, const Knobs& knobs) {
  constexpr double min_cost = 1e-3;
  if (knobs.method == Method::raster) return std::max(raster_cost(view, knobs), min_cost);
  const std::array<double, cost_terms> terms = cost_terms_of(view, knobs);
  double sum = 0;
  for (std::size_t i = 0; i < cost_terms; ++i) sum += model.prices[i] * terms[i];
  return std::max(sum, min_cost);
}

double predicted_error(const DialModel& model, const DialRow& row, const ViewFeatures& view) {
  constexpr double min_error = 1e-5;  // a smaller error counts as this
  const double fur = std::clamp(view.fur_pixels, model.min_fur, model.max_fur);
  return std::clamp(row.error * std::pow(fur, row.growth), min_error, 1.0);
}

}  // namespace pelage
