#include "renderer/raster/hand_on.h"

#include <algorithm>
#include <limits>

namespace pelage {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

}  // namespace

std::size_t SharedLight::light(const RasterScene& scene, const StrandSet& set, std::span<const std::uint32_t> ids,
                               std::size_t first, PlacedStrands& placed) {
  if (ids.empty()) return 0;
  const std::uint32_t own = (ids.back() + static_cast<std::uint32_t>(scene.quality.lit_of)) / static_cast<std::uint32_t>(scene.quality.lit_of);
  place_.assign(own, none), lit_.clear(), of_.clear();
  for (const std::uint32_t id : ids) {
    std::uint32_t from = id;
    while (from >= own) from = set.neighbour[from];
    if (place_[from] == none) place_[from] = static_cast<std::uint32_t>(lit_.size()), lit_.push_back(from);
    of_.push_back(place_[from]);
  }
  light_strands(scene, set, lit_, light_);
  const std::size_t stride = static_cast<std::size_t>(lit_points(set.segments)) * 3;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const std::uint32_t begin = placed.first[first + i], end = placed.first[first + i + 1];
    hand_on_light(set, ids[i], lit_[of_[i]], &light_[of_[i] * stride], std::span(placed.knots).subspan(begin, end - begin));
  }
  return lit_.size();
}

}  // namespace pelage
