#include "renderer/raster/hand_on.h"

#include <algorithm>
#include <limits>

namespace pelage {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

}  // namespace

std::size_t SharedLight::light(const RasterScene& scene, const GrownPart& part, std::span<const std::uint32_t> ids,
                               std::uint32_t last, std::size_t first, PlacedStrands& placed) {
  if (ids.empty()) return 0;
  const StrandSet& set = *part.strands;
  const bool single = part.role == StrandRole::curve;
  const bool shares = !single && is_coloured(scene.shown);
  const auto lit_of = static_cast<std::uint32_t>(shares ? scene.quality.lit_of : 1);
  const std::uint32_t own = (last + lit_of) / lit_of;
  place_.assign(own, none), lit_.clear(), of_.clear();
  for (const std::uint32_t id : ids) {
    std::uint32_t from = id;
    while (from >= own) from = set.neighbour[from];
    of_.push_back(from), place_[from] = 0;
  }
  for (std::uint32_t from = 0; from < own; ++from)
    if (place_[from] != none) place_[from] = static_cast<std::uint32_t>(lit_.size()), lit_.push_back(from);
  const std::uint32_t deep = single ? own : whole_strands(last);  // those before it are drawn from the root on
  const auto whole = static_cast<std::size_t>(std::lower_bound(lit_.begin(), lit_.end(), deep) - lit_.begin());
  light_strands(scene, part, std::span(lit_).first(whole), true, whole_);
  light_strands(scene, part, std::span(lit_).subspan(whole), false, rest_);
  at_.clear();
  for (const std::uint32_t from : of_) at_.push_back(place_[from]);
  hand_on_light(set, {ids, at_, whole_, rest_}, first, placed);
  return lit_.size();
}

}  // namespace pelage
