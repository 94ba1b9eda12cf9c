#include "server/groom/region.h"

#include <algorithm>
#include <unordered_map>

namespace pelage {

namespace {

/// For each vertex under the stroke the largest weight of any dab.
std::vector<VertexWeight> covered(const Stroke& stroke, const Brush& brush, const Surface& surface,
                                  const Cancel& cancel) {
  const BrushStroke painted(stroke, brush, surface);
  std::unordered_map<std::uint32_t, double> largest;
  std::vector<VertexWeight> weights;
  for (const Dab& dab : painted.covering_dabs()) {
    cancel.check();
    painted.weigh(dab, weights);
    for (const auto [vertex, weight] : weights) {
      double& so_far = largest[vertex];
      so_far = std::max(so_far, weight);
    }
  }
  weights.clear();
  for (const auto& [vertex, weight] : largest) weights.push_back({vertex, weight});
  std::sort(weights.begin(), weights.end(), [](auto a, auto b) { return a.vertex < b.vertex; });
  return weights;
}

std::vector<VertexWeight> everywhere(double weight, std::size_t vertices) {
  std::vector<VertexWeight> all;
  if (!(weight > 0)) return all;
  all.resize(vertices);
  for (std::uint32_t v = 0; v < vertices; ++v) all[v] = {v, weight};
  return all;
}

}  // namespace

std::vector<VertexWeight> region_of(const std::optional<Stroke>& stroke, const Brush& brush, const Surface& surface,
                                    const FieldSet& fields, const Cancel& cancel, Masked masked) {
  std::vector<VertexWeight> region =
      stroke ? covered(*stroke, brush, surface, cancel) : everywhere(brush.strength, fields.size());
  if (masked == Masked::no || fields.at_default(Field::mask)) return region;
  for (VertexWeight& place : region) place.weight *= fields.number(Field::mask, place.vertex);
  std::erase_if(region, [](const VertexWeight& place) { return !(place.weight > 0); });
  return region;
}

double strand_share(const Brush& brush, Field field) {
  if (field != Field::root_colour && field != Field::tip_colour) return 1;
  const double low = field == Field::root_colour ? 0 : 0.5, high = low + 0.5;
  return std::max(0.0, std::min(brush.strand_to, high) - std::max(brush.strand_from, low)) / 0.5;
}

}  // namespace pelage
