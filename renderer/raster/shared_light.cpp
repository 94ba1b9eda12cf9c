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
  lit_indices_.assign(last + std::size_t{1}, none), lit_.clear(), sources_.clear();
  for (const std::uint32_t id : ids) sources_.push_back(lit_strand(set, id, own)), lit_indices_[sources_.back()] = 0;
  for (std::uint32_t from = 0; from <= last; ++from)
    if (lit_indices_[from] != none) lit_indices_[from] = static_cast<std::uint32_t>(lit_.size()), lit_.push_back(from);
  const bool single = part.role == StrandRole::curve;
  const std::uint32_t deep = single ? own : strands_from_root(last);  // strands before it are drawn from the root on
  const auto from_root = static_cast<std::size_t>(std::lower_bound(lit_.begin(), lit_.end(), deep) - lit_.begin());
  light_strands(scene, part, std::span(lit_).first(from_root), true, from_root_);
  light_strands(scene, part, std::span(lit_).subspan(from_root), false, upper_part_);
  source_indices_.clear();
  for (const std::uint32_t from : sources_) source_indices_.push_back(lit_indices_[from]);
  distribute_light(set, {ids, sources_, source_indices_, from_root_, upper_part_, own_colour(scene, part)}, first,
                   placed);
  return lit_.size();
}

}  // namespace pelage
