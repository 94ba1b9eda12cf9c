// Light of strands that share it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/raster/kernels.h"

namespace pelage {

/// Lights one of several neighbouring strands and gives its light to the others, each by its own colours. A thread
/// keeps one of these to reuse its arrays.
class SharedLight {
 public:
  /// Writes the light of the strands `ids` of a part to their knots, which are those of `placed` from strand `first`
  /// on. `last` is the last strand that the frame keeps of the part, wherever it shows. Gives how many were lit.
  std::size_t light(const RasterScene& scene, const GrownPart& part, std::span<const std::uint32_t> ids,
                    std::uint32_t last, std::size_t first, PlacedStrands& placed);

 private:
  std::vector<std::uint32_t> lit_, of_, at_, place_;
  LitPoints whole_, rest_;
};

}  // namespace pelage
