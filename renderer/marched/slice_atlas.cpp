#include "renderer/marched/slice_atlas.h"

#include <cstring>

namespace pelage {

namespace {

void append(const SliceLevel& level, const std::vector<std::uint8_t>& bytes, std::vector<std::int32_t>& words) {
  const auto texels = static_cast<std::size_t>(level.texels) * static_cast<std::size_t>(level.texels);
  const std::size_t begin = words.size();
  words.resize(begin + texels * slice_count);
  for (std::size_t slice = 0; slice < slice_count; ++slice) {
    for (std::size_t texel = 0; texel < texels; ++texel)
      std::memcpy(&words[begin + texel * slice_count + slice], &bytes[4 * (slice * texels + texel)], 4);
  }
}

}  // namespace

SliceAtlas::SliceAtlas(const Slices& slices) : finest(slices.finest) {
  for (std::size_t i = 0; i < slices.levels.size(); ++i) {
    first[i] = static_cast<std::int32_t>(shapes.size());
    append(slices.levels[i], slices.levels[i].shape, shapes);
    append(slices.levels[i], slices.levels[i].colour, colours);
  }
}

}  // namespace pelage
