#include "renderer/raster/shared_light.h"

#include <algorithm>
#include <limits>

#include "renderer/raster/cull.h"

namespace pelage {

std::size_t SharedLight::light(const RasterScene& scene, const GrownPart& part, std::span<const std::uint32_t> ids,
                               std::uint32_t last, std::size_t first, PlacedStrands& placed) {
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  if (ids.empty()) return 0;
  const StrandSet& set = *part.strands;
  const std::uint32_t own = lit_strands(scene, part, last);
  place_.assign(last + std::size_t{1}, none), lit_.clear(), of_.clear();
  for (const std::uint32_t id : ids) of_.push_back(lit_strand(set, id, own)), place_[of_.back()] = 0;
  for (std::uint32_t from = 0; from <= last; ++from)
    if (place_[from] != none) place_[from] = static_cast<std::uint32_t>(lit_.size()), lit_.push_back(from);
  const bool single = part.role == StrandRole::curve;
  const std::uint32_t deep = single ? own : whole_strands(last);  // strands before it are drawn from the root on
  const auto whole = static_cast<std::size_t>(std::lower_bound(lit_.begin(), lit_.end(), deep) - lit_.begin());
  light_strands(scene, part, std::span(lit_).first(whole), true, whole_);
  light_strands(scene, part, std::span(lit_).subspan(whole), false, rest_);
  at_.clear();
  for (const std::uint32_t from : of_) at_.push_back(place_[from]);
  hand_on_light(set, {ids, of_, at_, whole_, rest_, own_colour(scene, part)}, first, placed);
  return lit_.size();
}

}  // namespace pelage
