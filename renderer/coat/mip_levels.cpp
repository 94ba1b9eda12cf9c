#include "renderer/coat/mip_levels.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>

#include "base/parallel.h"
#include "renderer/coat/strand_cover.h"
#include "renderer/coat/strand_tile.h"
#include "renderer/shaders/constants.h"

namespace pelage {

namespace {

using Stack = std::vector<std::vector<SliceTexel>>;

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::size_t at(int x, int y, int texels) {
  return static_cast<std::size_t>((y & (texels - 1)) * texels + (x & (texels - 1)));
}

/// Returns the opacity of an optical depth at 60 degrees to the stack.
float opacity(float depth) { return depth > 0 ? -std::expm1(-2 * depth) : 0.0f; }

/// Returns the weight of the plain mean in the light of a coarse texel (light_of). It includes the gaps, which are
/// brighter than the strands: of tight clumps, such as wet ones, mostly the outside is visible.
float seen_from_outside(const Coat& coat) {
  return static_cast<float>(0.6 * glm::mix(coat.clump, 1.0, water_gathers * coat.wetness));
}

/// Returns the light of four texels: a mix of their mean weighted by opacity and, with the weight `outside`, their
/// plain mean.
float light_of(const std::array<const SliceTexel*, 4>& parts, float outside) {
  const float first = parts[0]->light;
  if (std::all_of(parts.begin(), parts.end(), [&](const SliceTexel* part) { return part->light == first; }))
    return first;
  float light = 0, on_strands = 0, strands = 0;
  for (const SliceTexel* part : parts) {
    const float share = 1e-6f + opacity(part->depth);
    light += part->light / 4, on_strands += part->light * share, strands += share;
  }
  return glm::mix(on_strands / strands, light, outside);
}

constexpr double slants[] = {0, 1.7320508, 0.57735027, 3.7320508};  // tangents of the angles of depth_scale
constexpr int rays_of_tile = 64;                                    // rays along a side of the tile, at most
constexpr double min_let_through = 0.002;                           // share of rays below which a slice is not matched
constexpr float opaque_depth = 12;                                  // optical depth of a slice that counts as opaque

/// Finds the factor at which a decreasing function has the value `wanted`, by bisection of its base-2 logarithm from
/// `low` to `high`.
template <typename Falling>
double bisect(double low, double high, int steps, double wanted, const Falling& value) {
  for (int step = 0; step < steps; ++step) {
    const double middle = (low + high) / 2;
    (value(std::exp2(middle)) > wanted ? low : high) = middle;
  }
  return std::exp2((low + high) / 2);
}

/// Factors on the depths of each slice; they avoid copies of the stack.
using Factors = std::vector<float>;

/// Returns the offset of ray k within its texel, in [0, 1)^2. Pixels lie anywhere on texels, so the offsets fill the
/// square evenly (R2 sequence, Roberts 2018).
glm::dvec2 between_texels(std::size_t k) {
  const auto part = [&](double step) {
    const double far = 0.5 + step * static_cast<double>(k);
    return far - static_cast<double>(static_cast<std::int64_t>(far));
  };
  return {part(0.7548776662466927), part(0.5698402909980532)};
}

/// Returns the optical depth at a position, in texels, as the shader's bilinear filter reads it: thin strands are
/// spread over four texels, and so occlude more.
double filtered_depth(const std::vector<SliceTexel>& slice, int texels, glm::dvec2 position) {
  const glm::ivec2 low(glm::floor(position));
  const glm::dvec2 part = position - glm::dvec2(low);
  const auto depth = [&](int x, int y) { return static_cast<double>(slice[at(low.x + x, low.y + y, texels)].depth); };
  return glm::mix(glm::mix(depth(0, 0), depth(1, 0), part.x), glm::mix(depth(0, 1), depth(1, 1), part.x), part.y);
}

/// Calls `use` with the number and the tile position, in texels, of each ray.
template <typename Use>
void for_rays(int texels, const Use& use) {
  const int stride = std::max(1, texels / rays_of_tile);
  std::size_t k = 0;
  for (int y = 0; y < texels; y += stride) {
    for (int x = 0; x < texels; x += stride, ++k) use(k, glm::dvec2(x, y) + between_texels(k));
  }
}

/// Returns the optical depth of all slices along the stack, for each ray.
std::vector<double> depths_of_columns(const Stack& stack, const Factors& factors, int texels) {
  std::vector<double> depths(static_cast<std::size_t>(std::min(texels, rays_of_tile) * std::min(texels, rays_of_tile)),
                             0.0);
  for (std::size_t i = 0; i < stack.size(); ++i) {
    for_rays(texels, [&](std::size_t k, glm::dvec2 position) {
      depths[k] += filtered_depth(stack[i], texels, position) * static_cast<double>(factors[i]);
    });
  }
  return depths;
}

/// Returns the scale at which the whole stack has the mean transmittance `wanted`. Bisection works, because
/// transmittance falls with the scale.
double matching_scale(const Stack& stack, const Factors& factors, int texels, double wanted) {
  const std::vector<double> depths = depths_of_columns(stack, factors, texels);
  return bisect(-12, 6, 24, wanted, [&](double scale) {
    double sum = 0;
    for (const double depth : depths) sum += std::exp(-scale * depth);
    return sum / static_cast<double>(depths.size());
  });
}

/// Returns the optical depths of one slice along rays that move by `shift` texels from slice to slice.
std::vector<double> depths_along(const std::vector<SliceTexel>& slice, int texels, double shift, std::size_t index) {
  const int parts = std::clamp(static_cast<int>(std::ceil(shift)), 1, 4);
  std::vector<double> depths;
  for_rays(texels, [&](std::size_t, glm::dvec2 position) {
    double depth = 0;
    for (int part = 0; part < parts; ++part) {
      const double height = static_cast<double>(index) + (part + 0.5) / parts;
      depth += filtered_depth(slice, texels, position + glm::dvec2(shift * height, 0));
    }
    depths.push_back(depth / parts);
  });
  return depths;
}

/// Rays on their way down the stack at 60 degrees: the optical depth behind them, and that of the current slice.
struct SlantedRays {
  std::vector<double> reached, here;

  double past(std::size_t k, double factor) const { return std::exp(-reached[k] - 2 * factor * here[k]); }

  double transmittance(double factor) const {
    double sum = 0;
    for (std::size_t k = 0; k < here.size(); ++k) sum += past(k, factor);
    return sum / static_cast<double>(here.size());
  }

  /// Returns the uncertainty of `transmittance` for this number of rays: half of their standard error, because evenly
  /// spread rays have less error than random ones.
  double uncertainty(double factor) const {
    const double mean = transmittance(factor);
    double squares = 0;
    for (std::size_t k = 0; k < here.size(); ++k) squares += (past(k, factor) - mean) * (past(k, factor) - mean);
    return 0.5 * std::sqrt(squares) / static_cast<double>(here.size());
  }

  /// Returns the factor at which about the share `wanted` of the rays gets past; within a factor of 2 of `last`, or any
  /// for the first slice with strands. It differs from `last` only if the rays' uncertainty cannot explain the
  /// difference: deep in fur of wide strands few rays are left, and an exact factor for them would swing from slice to
  /// slice.
  double match(double wanted, std::optional<double> last) const {
    const double as_last = transmittance(last.value_or(1)), unknown = last ? uncertainty(*last) : 0;
    const double aim = std::clamp(as_last, wanted - unknown, wanted + unknown);
    if (aim == as_last) return last.value_or(1);
    const double middle = last ? std::log2(*last) : 0, range = last ? 1 : 5;
    return bisect(std::max(-5.0, middle - range), std::min(5.0, middle + range), 16, aim,
                  [&](double factor) { return transmittance(factor); });
  }
};

/// Returns factors at which, at 60 degrees, the transmittance of each slice and all slices above it matches that of the
/// strands. Matching only the mean over the whole stack fails: in dense fur that mean comes from the widest gaps alone,
/// and a stack that preserves it is far too transparent at the tips, which are the visible part.
Factors match_slices(const Stack& stack, int texels, double shift, const std::array<double, slice_count>& wanted) {
  SlantedRays rays;
  std::optional<double> factor;
  Factors factors(stack.size());
  for (std::size_t i = stack.size(); i-- > 0;) {
    rays.here = depths_along(stack[i], texels, shift, i);
    rays.reached.resize(rays.here.size(), 0.0);
    if (wanted[i] > min_let_through && wanted[i] < 1) factor = rays.match(wanted[i], factor);
    const double used = factor.value_or(1);
    for (std::size_t k = 0; k < rays.here.size(); ++k) rays.reached[k] += 2 * used * rays.here[k];
    factors[i] = static_cast<float>(used);
  }
  return factors;
}

/// Returns the scale on the depths of matched slices at which the transmittance of slanted rays, averaged over the
/// slices, is `wanted`: they reach as deep as between the strands.
double reaching_scale(const Stack& stack, const Factors& factors, int texels, double shift, double wanted) {
  std::vector<std::vector<double>> depths;
  for (std::size_t i = 0; i < stack.size(); ++i) {
    depths.push_back(depths_along(stack[i], texels, shift, i));
    for (double& depth : depths.back()) depth *= static_cast<double>(factors[i]);
  }
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

/// Scales the factors so that the largest depth fits into a byte. Returns the factor that undoes it.
double fit_to_bytes(const Stack& stack, Factors& factors) {
  float largest = 1e-3f;
  for (std::size_t i = 0; i < stack.size(); ++i) {
    for (const SliceTexel& texel : stack[i]) largest = std::max(largest, texel.depth * factors[i]);
  }
  const float fitting = static_cast<float>(stored_depth) / std::min(largest, opaque_depth);
  for (float& factor : factors) factor *= fitting;
  return 1 / static_cast<double>(fitting);
}

std::uint8_t byte(double value) { return static_cast<std::uint8_t>(std::clamp(value, 0.0, 1.0) * 255 + 0.5); }

/// The slope and colour of a texel in stored form.
struct Look {
  std::array<std::uint8_t, 2> slope;
  std::array<std::uint8_t, 4> colour;
};

Look look_of(const SliceTexel& texel) {
  const float weight = std::max(texel.depth, 1e-6f);
  const auto slope = [&](float sum) { return byte(0.5 + 0.5 * static_cast<double>(sum / weight) / stored_slope); };
  const auto root = [&](float sum) { return byte(std::sqrt(static_cast<double>(sum / weight))); };
  return {{slope(texel.slope.x), slope(texel.slope.y)},
          {root(texel.colour.r), root(texel.colour.g), root(texel.colour.b), byte(static_cast<double>(texel.number))}};
}

void store(float depth, float light, const Look& look, std::uint8_t* shape, std::uint8_t* colour) {
  std::copy(look.slope.begin(), look.slope.end(), shape);
  shape[2] = byte(static_cast<double>(light));
  shape[3] = byte(static_cast<double>(depth) / stored_depth);
  std::copy(look.colour.begin(), look.colour.end(), colour);
}

/// Returns the slice's mean, which empty texels take, so that filtering never mixes in a colour that no strand has.
SliceTexel mean_texel(const std::vector<SliceTexel>& slice) {
  SliceTexel sum;
  for (const SliceTexel& texel : slice) sum.add(texel);
  return sum;
}

SliceLevel pack(const Stack& stack, const Factors& factors, int texels) {
  SliceLevel level{.texels = texels, .shape = {}, .colour = {}};
  const std::size_t count = static_cast<std::size_t>(texels) * static_cast<std::size_t>(texels);
  level.shape.resize(4 * count * stack.size());
  level.colour.resize(4 * count * stack.size());
  for (std::size_t i = 0; i < stack.size(); ++i) {
    const Look filler = look_of(mean_texel(stack[i]));
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t offset = 4 * (i * count + k);
      const SliceTexel& texel = stack[i][k];
      const float depth = texel.depth * factors[i];
      store(depth, texel.light, depth > 1e-4f ? look_of(texel) : filler, &level.shape[offset], &level.colour[offset]);
    }
  }
  return level;
}

using SlantTransmittance = std::array<std::array<double, slice_count>, 4>;  // for each of `slants`, then for each slice

/// Returns a slice of `texels` a side at half the resolution.
std::vector<SliceTexel> halved(const Coat& coat, const std::vector<SliceTexel>& slice, int texels) {
  const float outside = seen_from_outside(coat);
  const int half = texels / 2;
  std::vector<SliceTexel> result(static_cast<std::size_t>(half * half));
  for (int y = 0; y < half; ++y) {
    for (int x = 0; x < half; ++x) {
      SliceTexel& sum = result[at(x, y, half)];
      std::array<const SliceTexel*, 4> parts{};
      for (int k = 0; k < 4; ++k) {
        const SliceTexel& part = slice[at(2 * x + k % 2, 2 * y + k / 2, texels)];
        sum.add(part), parts[static_cast<std::size_t>(k)] = &part;
      }
      sum.depth /= 4, sum.slope /= 4.0f, sum.colour /= 4.0f, sum.light = light_of(parts, outside);
    }
  }
  return result;
}

Stack halved_stack(const Coat& coat, const Stack& stack, int texels) {
  Stack result;
  for (const std::vector<SliceTexel>& slice : stack) result.push_back(halved(coat, slice, texels));
  return result;
}

SliceLevel make_level(const Coat& coat, const Stack& stack, int texels, const SlantTransmittance& traced) {
  const double across =
      nominal_length / slice_count / coat.tile * texels;  // texels that a ray at 45 degrees moves for each slice
  Factors factors = match_slices(stack, texels, slants[1] * across, traced[1]);
  const double scale = fit_to_bytes(stack, factors);
  SliceLevel level = pack(stack, factors, texels);
  const auto at_slant = [&](std::size_t k) {
    return reaching_scale(stack, factors, texels, slants[k] * across, mean_of(traced[k])) / std::hypot(1.0, slants[k]);
  };
  level.depth_scale = {std::min(matching_scale(stack, factors, texels, traced[0][0]), 2 * scale), scale, at_slant(2),
                       at_slant(3)};
  return level;
}

}  // namespace

StackLight light_from_above(const Coat& coat, const std::vector<Strand>& strands) {
  const CrossingGrid crossings = crossings_of(coat, strands);
  StackLight result;
  std::vector<double> above(crossing_cells * crossing_cells, 0.0);
  for (std::size_t i = slice_count; i-- > 0;) {
    for (std::size_t k = 0; k < above.size(); ++k) above[k] += 0.5 * crossings[i][k];
    const double mean = mean_of(above);
    // Light comes from all sides, so a position between clumps is half under the strands straight above it and half
    // under the mean.
    for (const double here : above)
      result.cells[i].push_back(static_cast<float>(std::exp(-(0.5 * mean + 0.5 * here) / stored_light)));
    result.depth_above[i] = static_cast<float>(mean);
    for (std::size_t k = 0; k < above.size(); ++k) above[k] += 0.5 * crossings[i][k];
  }
  return result;
}

void set_light(const std::vector<float>& cells, std::vector<SliceTexel>& slice) {
  constexpr int texels_of_cell = slice_texels / crossing_cells;
  for (int y = 0; y < slice_texels; ++y) {
    for (int x = 0; x < slice_texels; ++x)
      slice[at(x, y, slice_texels)].light = cells[at(x / texels_of_cell, y / texels_of_cell, crossing_cells)];
  }
}

std::vector<SliceLevel> build_levels(const Coat& coat, const std::vector<Strand>& strands, Stack stack) {
  assert(stack.size() == slice_count);
  SlantTransmittance traced;
  const auto transmittance = [&](std::size_t k) { traced[k] = ray_transmittance(coat, strands, slants[k]); };
  run_both([&] { transmittance(1), transmittance(3); }, [&] { transmittance(0), transmittance(2); });
  std::vector<SliceLevel> levels(slice_levels);
  run_both([&] { levels[0] = make_level(coat, stack, slice_texels, traced); },
           [&] {
             const Stack* finer = &stack;
             Stack coarse;
             for (int level = 1; level < slice_levels; ++level) {
               coarse = halved_stack(coat, *finer, slice_texels >> (level - 1)), finer = &coarse;
               levels[static_cast<std::size_t>(level)] = make_level(coat, coarse, slice_texels >> level, traced);
             }
           });
  return levels;
}

}  // namespace pelage
