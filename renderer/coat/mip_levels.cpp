#include "renderer/coat/mip_levels.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <span>

#include "renderer/coat/strand_cover.h"
#include "renderer/coat/strand_tile.h"

namespace pelage {

namespace {

using Stack = std::vector<std::vector<SliceTexel>>;

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::size_t at(int x, int y, int texels) {
  return static_cast<std::size_t>((y & (texels - 1)) * texels + (x & (texels - 1)));
}

/// At 60 degrees to the stack.
float opacity(float depth) { return depth > 0 ? -std::expm1(-2 * depth) : 0.0f; }

/// Light is half that on strands, for gaps between clumps are brighter than the clumps, and half the mean, for what one sees
/// of a clump is its outside.
Stack halve(const Stack& stack, int texels) {
  const int half = texels / 2;
  Stack result(stack.size(), std::vector<SliceTexel>(static_cast<std::size_t>(half * half)));
  for (std::size_t i = 0; i < stack.size(); ++i) {
    for (int y = 0; y < half; ++y) {
      for (int x = 0; x < half; ++x) {
        SliceTexel sum;
        float light = 0, on_strands = 0, strands = 0;
        for (int k = 0; k < 4; ++k) {
          const SliceTexel& part = stack[i][at(2 * x + k % 2, 2 * y + k / 2, texels)];
          sum.add(part);
          const float share = 1e-6f + opacity(part.depth);
          light += part.light / 4, on_strands += part.light * share, strands += share;
        }
        sum.depth /= 4, sum.slope /= 4.0f, sum.colour /= 4.0f, sum.light = (light + on_strands / strands) / 2;
        result[i][at(x, y, half)] = sum;
      }
    }
  }
  return result;
}

constexpr double slants[] = {0, 1.7320508, 0.57735027, 3.7320508};  // tangents of the angles of depth_scale
constexpr int slanted_rays = 64;             // on a side, at most
constexpr double least_let_through = 0.002;  // of rays: less says nothing about a slice
constexpr float opaque_depth = 12;           // of a slice; more is not told apart

/// The factor for which a falling function has that value; bisection in its logarithm (base 2), from `low` to `high`.
template <typename Falling>
double bisect(double low, double high, int steps, double wanted, const Falling& value) {
  for (int step = 0; step < steps; ++step) {
    const double middle = (low + high) / 2;
    (value(std::exp2(middle)) > wanted ? low : high) = middle;
  }
  return std::exp2((low + high) / 2);
}

/// Mean over the tile of what a ray along the stack lets through, with depths scaled by `scale`. Every fourth texel is
/// enough at full size.
double mean_transmittance(const Stack& stack, int texels, double scale) {
  const int stride = texels > 128 ? 4 : 1;
  double sum = 0;
  int count = 0;
  for (int y = 0; y < texels; y += stride) {
    for (int x = 0; x < texels; x += stride) {
      double depth = 0;
      for (const std::vector<SliceTexel>& slice : stack) depth += static_cast<double>(slice[at(x, y, texels)].depth);
      sum += std::exp(-scale * depth), ++count;
    }
  }
  return sum / count;
}

/// The scale for which the whole stack lets through what is wanted; bisection in the logarithm, as it is monotone.
double matching_scale(const Stack& stack, int texels, double wanted) {
  return bisect(-12, 6, 24, wanted, [&](double scale) {
    return mean_transmittance(stack, texels, scale);
  });
}

/// Depths of one slice along rays that enter it `shift` texels further for each slice above the first.
std::vector<double> depths_along(const std::vector<SliceTexel>& slice, int texels, double shift, std::size_t index) {
  const int stride = std::max(1, texels / slanted_rays), parts = std::clamp(static_cast<int>(std::ceil(shift)), 1, 4);
  std::vector<double> depths;
  for (int y = 0; y < texels; y += stride) {
    for (int x = 0; x < texels; x += stride) {
      double depth = 0;
      for (int part = 0; part < parts; ++part) {
        const double height = static_cast<double>(index) + (part + 0.5) / parts;
        depth += static_cast<double>(slice[at(x + static_cast<int>(std::floor(shift * height + 0.5)), y, texels)].depth);
      }
      depths.push_back(depth / parts);
    }
  }
  return depths;
}

/// Scales each slice's depths so that at 60 degrees as many rays get past it, and all that lie above, as get past the
/// strands. A mean over the whole stack would not do: dense fur lets so little through that the mean is of the widest
/// gaps alone, and a stack that keeps it is far too thin at the tips, which are what one sees.
void match_slices(Stack& stack, int texels, double shift, const std::array<double, slice_count>& wanted) {
  std::vector<double> reached;
  double factor = 1;
  for (std::size_t i = stack.size(); i-- > 0;) {
    const std::vector<double> here = depths_along(stack[i], texels, shift, i);
    reached.resize(here.size(), 0.0);
    if (wanted[i] > least_let_through && wanted[i] < 1) {
      factor = bisect(-5, 5, 16, wanted[i], [&](double scale) {
        double sum = 0;
        for (std::size_t k = 0; k < here.size(); ++k) sum += std::exp(-reached[k] - 2 * scale * here[k]);
        return sum / static_cast<double>(here.size());
      });
    }
    for (std::size_t k = 0; k < here.size(); ++k) reached[k] += 2 * factor * here[k];
    for (SliceTexel& texel : stack[i]) texel.scale(static_cast<float>(factor));
  }
}

/// The factor on the depths of matched slices for which rays at a slant reach as deep on average as they do between the
/// strands: what they let through, averaged over the slices, is `wanted`.
double reaching_scale(const Stack& stack, int texels, double shift, double wanted) {
  std::vector<std::vector<double>> depths;
  for (std::size_t i = 0; i < stack.size(); ++i) depths.push_back(depths_along(stack[i], texels, shift, i));
  std::vector<double> reached;
  return bisect(-12, 6, 20, wanted, [&](double scale) {
    double sum = 0;
    reached.assign(depths.front().size(), 0.0);
    for (std::size_t i = depths.size(); i-- > 0;) {
      for (std::size_t k = 0; k < reached.size(); ++k) sum += std::exp(-scale * (reached[k] += depths[i][k]));
    }
    return sum / static_cast<double>(reached.size() * depths.size());
  });
}

/// Brings the largest depth to what an octet holds. Answers the factor that undoes it.
double fit_to_octets(Stack& stack) {
  float largest = 1e-3f;
  for (const std::vector<SliceTexel>& slice : stack) {
    for (const SliceTexel& texel : slice) largest = std::max(largest, texel.depth);
  }
  const float fitting = static_cast<float>(stored_depth) / std::min(largest, opaque_depth);
  for (std::vector<SliceTexel>& slice : stack) {
    for (SliceTexel& texel : slice) texel.scale(fitting);
  }
  return 1 / static_cast<double>(fitting);
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

/// Strands between each texel and light from above. Light comes from all sides, so a place between clumps lies a quarter
/// under what is straight above it and the rest under the mean.
void light_from_above(const CrossingGrid& crossings, Stack& stack) {
  constexpr int texels_of_cell = slice_texels / crossing_cells;
  std::vector<double> above(crossing_cells * crossing_cells, 0.0);
  for (std::size_t i = stack.size(); i-- > 0;) {
    for (std::size_t k = 0; k < above.size(); ++k) above[k] += 0.5 * crossings[i][k];
    const double mean = mean_of(above);
    for (int y = 0; y < slice_texels; ++y) {
      for (int x = 0; x < slice_texels; ++x) {
        const double here = above[at(x / texels_of_cell, y / texels_of_cell, crossing_cells)];
        stack[i][at(x, y, slice_texels)].light = static_cast<float>(std::exp(-(0.75 * mean + 0.25 * here) / stored_light));
      }
    }
    for (std::size_t k = 0; k < above.size(); ++k) above[k] += 0.5 * crossings[i][k];
  }
}

std::array<float, slice_count> depth_above(const CrossingGrid& crossings) {
  std::array<float, slice_count> result{};
  double above = 0;
  for (std::size_t i = slice_count; i-- > 0;) {
    const double here = mean_of(crossings[i]);
    result[i] = static_cast<float>(above + 0.5 * here);
    above += here;
  }
  return result;
}

}  // namespace

Slices build_levels(const Coat& coat, const std::vector<Strand>& strands, Stack stack) {
  assert(stack.size() == slice_count);
  const CrossingGrid crossings = crossings_of(coat, strands);
  light_from_above(crossings, stack);
  Slices slices;
  slices.depth_above = depth_above(crossings);
  const double across = nominal_length / slice_count / coat.tile;  // for each slice of a ray at 45 degrees, in tiles
  std::array<std::array<double, slice_count>, 4> open;
  for (std::size_t k = 0; k < open.size(); ++k) open[k] = rays_let_through(coat, strands, slants[k]);
  for (int level = 0, texels = slice_texels; level < slice_levels; ++level, texels /= 2) {
    if (level > 0) stack = halve(stack, texels * 2);
    Stack matched = stack;
    match_slices(matched, texels, slants[1] * across * texels, open[1]);
    const double scale = fit_to_octets(matched);
    slices.levels.push_back(pack(matched, texels));
    const auto at_slant = [&](std::size_t k) {
      const double wanted = mean_of(open[k]);
      return reaching_scale(matched, texels, slants[k] * across * texels, wanted) / std::hypot(1.0, slants[k]);
    };
    slices.levels.back().depth_scale = {std::min(matching_scale(matched, texels, open[0][0]), 2 * scale), scale,
                                        at_slant(2), at_slant(3)};
  }
  return slices;
}

}  // namespace pelage
