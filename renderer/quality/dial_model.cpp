#include "renderer/quality/dial_model.h"

#include <algorithm>
#include <cmath>

#include "renderer/input/raster_quality.h"

namespace pelage {

Knobs dial_knobs(double strands, int light_of, double scale) {
  Knobs knobs = knobs_of(Tier::interactive);
  knobs.raster = {.strands = strands, .light_of = light_of}, knobs.scale = scale;
  return knobs;
}

std::array<double, cost_terms> cost_terms_of(const ViewFeatures& view, const Knobs& knobs) {
  constexpr double million = 1e6, hundred_thousand = 1e5;
  constexpr double aslant = 1.3;  // strands on a pixel of visible skin, over those on a pixel of skin seen from above
  const double pixels = view.pixels * knobs.scale * knobs.scale;
  const double on_a_pixel = view.strands / std::max(aslant * view.area * knobs.scale * knobs.scale, 1e-12);
  const double drawn =
      view.strands * quality_of(knobs, view.winding).drawn_strand_share(on_a_pixel, view.width_pixels * knobs.scale);
  return {1,
          pixels / million,
          view.strands / hundred_thousand,
          drawn / hundred_thousand,
          drawn * view.lights / (knobs.raster.light_of * hundred_thousand),
          drawn * view.winding * view.fur_pixels * knobs.scale / million,
          view.area * knobs.scale * knobs.scale / hundred_thousand};
}

namespace {

double shells_cost(const ViewFeatures& view, const Layering& shells, double scale) {
  constexpr double million_fragments = 100, sorted = 10;  // milliseconds on a software GL; factor for sorting
  const double fragments = scale * scale * view.area * shells.count / 1e6;
  return million_fragments * fragments * (shells.order == FragmentOrder::sorted ? sorted : 1);
}

}  // namespace

double predicted_cost(const DialModel& model, const ViewFeatures& view, const Knobs& knobs) {
  constexpr double min_cost = 1e-3;
  if (knobs.method == Method::shells) return std::max(shells_cost(view, knobs.shells, knobs.scale), min_cost);
  const std::array<double, cost_terms> terms = cost_terms_of(view, knobs);
  double sum = 0;
  for (std::size_t i = 0; i < cost_terms; ++i) sum += model.coefficients[i] * terms[i];
  return std::max(sum, min_cost);
}

double predicted_error(const DialModel& model, const DialRow& row, const ViewFeatures& view) {
  constexpr double min_error = 1e-5;  // a smaller error counts as this
  const double fur = std::clamp(view.fur_pixels, model.min_fur, model.max_fur);
  return std::clamp(row.error * std::pow(fur, row.growth), min_error, 1.0);
}

}  // namespace pelage
