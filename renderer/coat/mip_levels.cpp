#include "renderer/coat/mip_levels.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "renderer/coat/strand_tile.h"

namespace pelage {

namespace {

using Stack = std::vector<std::vector<SliceTexel>>;

std::size_t at(int x, int y, int texels) {
  return static_cast<std::size_t>((y & (texels - 1)) * texels + (x & (texels - 1)));
}

Stack halve(const Stack& stack, int texels) {
  const int half = texels / 2;
  Stack result(stack.size(), std::vector<SliceTexel>(static_cast<std::size_t>(half * half)));
  for (std::size_t i = 0; i < stack.size(); ++i) {
    for (int y = 0; y < half; ++y) {
      for (int x = 0; x < half; ++x) {
        SliceTexel sum;
        for (int k = 0; k < 4; ++k) sum.add(stack[i][at(2 * x + k % 2, 2 * y + k / 2, texels)]);
        sum.depth /= 4, sum.slope /= 4.0f, sum.colour /= 4.0f, sum.light /= 4;
        result[i][at(x, y, half)] = sum;
      }
    }
  }
  return result;
}

/// Mean over the tile of what a ray lets through that moves `shift` texels sideways from slice to slice, with depths
/// scaled by `scale`. Every fourth texel is enough at full size.
double mean_transmittance(const Stack& stack, int texels, double shift, double scale) {
  const int stride = texels > 128 ? 4 : 1;
  double sum = 0;
  int count = 0;
  for (int y = 0; y < texels; y += stride) {
    for (int x = 0; x < texels; x += stride) {
      double depth = 0;
      for (std::size_t i = 0; i < stack.size(); ++i) {
        depth += static_cast<double>(
            stack[i][at(x + static_cast<int>(std::lround(shift * static_cast<double>(i))), y, texels)].depth);
      }
      sum += std::exp(-scale * depth), ++count;
    }
  }
  return sum / count;
}

/// The scale for which the level lets through what the finest one does; bisection in the logarithm, as it is monotone.
double matching_scale(const Stack& stack, int texels, double shift, double path, double wanted) {
  double low = -12, high = 6;
  for (int step = 0; step < 24; ++step) {
    const double middle = (low + high) / 2;
    (mean_transmittance(stack, texels, shift, path * std::exp2(middle)) > wanted ? low : high) = middle;
  }
  return std::exp2((low + high) / 2);
}

std::uint8_t octet(double value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255)); }

void store(const SliceTexel& texel, const SliceTexel& filler, std::uint8_t* shape, std::uint8_t* colour) {
  const SliceTexel& look = texel.depth > 1e-4f ? texel : filler;
  const float weight = std::max(look.depth, 1e-6f);
  shape[0] = octet(0.5 + 0.5 * static_cast<double>(look.slope.x / weight) / stored_slope);
  shape[1] = octet(0.5 + 0.5 * static_cast<double>(look.slope.y / weight) / stored_slope);
  shape[2] = octet(static_cast<double>(texel.light));
  shape[3] = octet(static_cast<double>(texel.depth) / stored_depth);
  for (int k = 0; k < 3; ++k) colour[k] = octet(std::sqrt(static_cast<double>(look.colour[k] / weight)));
  colour[3] = octet(static_cast<double>(look.number));
}

/// What empty texels take, so that filtering never mixes in a colour that no strand has: the slice's mean.
SliceTexel mean_texel(const std::vector<SliceTexel>& slice) {
  SliceTexel sum;
  for (const SliceTexel& texel : slice) sum.add(texel);
  return sum;
}

SliceLevel pack(const Stack& stack, int texels) {
  SliceLevel level{.texels = texels, .shape = {}, .colour = {}};
  const std::size_t count = static_cast<std::size_t>(texels) * static_cast<std::size_t>(texels);
  level.shape.resize(4 * count * stack.size());
  level.colour.resize(4 * count * stack.size());
  for (std::size_t i = 0; i < stack.size(); ++i) {
    const SliceTexel filler = mean_texel(stack[i]);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t place = 4 * (i * count + k);
      store(stack[i][k], filler, &level.shape[place], &level.colour[place]);
    }
  }
  return level;
}

/// Light that reaches a slab from above, by the coverage of what lies above it within a few texels: strands deep
/// between tufts are darker than those on a tuft's top. Filtered on a quarter of the size, which is the reach of
/// scattering.
void light_from_above(const Coat& coat, Stack& stack) {
  constexpr int coarse = slice_texels / 8;
  Stack small = halve(halve(halve(stack, slice_texels), slice_texels / 2), slice_texels / 4);
  // Crossings of a slanted ray count, and most of the light goes on after each: science.md, ../look: .55 to .88 kept.
  const double slant = nominal_length / slice_count * slice_texels / coat.tile;
  const double kept = 0.42 * std::min(1.0, slant / 4);
  std::vector<double> above(coarse * coarse, 0.0);
  for (std::size_t i = stack.size(); i-- > 0;) {
    const double mean = std::accumulate(above.begin(), above.end(), 0.0) / static_cast<double>(above.size());
    for (int y = 0; y < slice_texels; ++y) {
      for (int x = 0; x < slice_texels; ++x) {
        // Light comes from the side too, so a gap between tufts is no brighter than the fur around it.
        const double depth = 0.5 * mean + 0.5 * std::max(mean, above[at(x / 8, y / 8, coarse)]);
        stack[i][at(x, y, slice_texels)].light = static_cast<float>(std::exp(-kept * depth));
      }
    }
    for (std::size_t k = 0; k < above.size(); ++k) above[k] += std::min(1.0, static_cast<double>(small[i][k].depth));
  }
}

std::array<float, slice_count> depth_above(const Stack& stack) {
  std::array<float, slice_count> result{};
  for (std::size_t i = 0; i < stack.size(); ++i) {
    double sum = 0;
    for (const SliceTexel& texel : stack[i]) sum += static_cast<double>(texel.light);
    result[i] = static_cast<float>(-std::log(std::max(sum / static_cast<double>(stack[i].size()), 1e-6)));
  }
  return result;
}

}  // namespace

Slices build_levels(const Coat& coat, Stack stack) {
  assert(stack.size() == slice_count);
  light_from_above(coat, stack);
  Slices slices;
  slices.depth_above = depth_above(stack);
  const double shift = std::sqrt(3.0) * nominal_length / slice_count / coat.tile;  // of 60 degrees, in tiles
  const double along = mean_transmittance(stack, slice_texels, 0, 1);
  const double slanted = mean_transmittance(stack, slice_texels, shift * slice_texels, 2);
  for (int level = 0, texels = slice_texels; level < slice_levels; ++level, texels /= 2) {
    if (level > 0) stack = halve(stack, texels * 2);
    slices.levels.push_back(pack(stack, texels));
    if (level == 0) continue;
    slices.levels.back().depth_scale = {matching_scale(stack, texels, 0, 1, along),
                                        matching_scale(stack, texels, shift * texels, 2, slanted)};
  }
  return slices;
}

}  // namespace pelage
