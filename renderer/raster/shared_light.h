// Lights one strand of each group and shares its light with the others.
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
  /// on. `last` is the last strand of the part that the frame keeps, wherever it shows. Returns the number of lit
  /// strands.
  std::size_t light(const RasterScene& scene, const GrownPart& part, std::span<const std::uint32_t> ids,
                    std::uint32_t last, std::size_t first, PlacedStrands& placed);

 private:
  // Strands that are lit; for each of `ids` its lit strand, and that one's index in lit_; index in lit_ of each strand.
  std::vector<std::uint32_t> lit_, sources_, source_indices_, lit_indices_;
  LitPoints from_root_, upper_part_;
};

}  // namespace pelage
