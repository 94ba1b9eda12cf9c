#include "renderer/coat/slices.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "base/parallel.h"
#include "renderer/coat/mip_levels.h"
#include "renderer/coat/strand_tile.h"

namespace pelage {

namespace {

// Mean number of discs over each texel at which a slice counts as opaque: each adds a depth of 5.8, and no more than
// stored_depth is stored.
constexpr double opaque_cover = 16;
const double max_depth = -std::log1p(-0.997);  // optical depth of one disc

/// One strand's cross-section at a slice's height.
struct Sprite {
  glm::dvec2 centre;  // texels
  double radius;      // texels
  glm::vec2 slope;
  glm::vec3 colour;
  float number;
};

int wrap(int i) { return i & (slice_texels - 1); }

/// Returns the share of a texel that a disc covers, with a soft rim; a disc thinner than a texel keeps its area.
double coverage(double distance, double radius) {
  const double reach = std::max(radius, 0.5);
  const double share = std::min(1.0, (radius * radius) / (reach * reach));
  return share * std::clamp(reach + 0.5 - distance, 0.0, 1.0);
}

void draw(const Sprite& sprite, std::vector<SliceTexel>& slice) {
  const double reach = std::max(sprite.radius, 0.5) + 0.5;
  const glm::ivec2 low(glm::floor(sprite.centre - reach)), high(glm::ceil(sprite.centre + reach));
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      const double share = coverage(glm::distance(sprite.centre, glm::dvec2(x + 0.5, y + 0.5)), sprite.radius);
      if (share <= 0) continue;
      const float depth = static_cast<float>(share >= 0.997 ? max_depth : -std::log1p(-share));
      slice[static_cast<std::size_t>(wrap(y) * slice_texels + wrap(x))].add(
          {depth, sprite.slope * depth, sprite.colour * depth, sprite.number, 0});
    }
  }
}

Sprite cross_section(const Coat& coat, const Strand& strand, double s) {
  const double q = std::min(1.0, s / strand.length_share), step = 0.02;
  const double low = std::max(0.0, q - step), high = std::min(1.0, q + step);
  const auto slope_of = [&](auto offset) {
    return (offset(coat, strand, high) - offset(coat, strand, low)) / ((high - low) * strand.length_share);
  };
  // A film of water shines along the clump as a whole, not along the strands that bend towards it.
  const glm::dvec2 slope = glm::mix(slope_of(strand_offset), slope_of(free_offset), coat.wetness);
  const double to_texels = slice_texels / coat.tile;
  const double radius = 0.5 * strand.width * glm::mix(coat.width_root, coat.width_tip, q);
  return {(strand.root + strand_offset(coat, strand, q)) * to_texels,
          std::min(radius * to_texels, double{slice_texels}),  // at this radius it covers the whole tile
          glm::vec2(slope), strand_colour(coat, strand, q), static_cast<float>(strand.number)};
}

/// Bakes a slice. Stops at opaque_cover: any prefix of the strands covers the tile evenly (strand_tile.cpp), and all of
/// the widest strands would take days.
std::vector<SliceTexel> bake_slice(const Coat& coat, const std::vector<Strand>& strands, int index) {
  std::vector<SliceTexel> slice(slice_texels * slice_texels);
  const double s = (index + 0.5) / slice_count;
  double cover = 0;
  for (const Strand& strand : strands) {
    if (cover > opaque_cover) break;
    const double inside =
        (strand.length_share - s) * slice_count + 0.5;  // part of the slab that the strand reaches into
    if (inside <= 0) continue;
    Sprite sprite = cross_section(coat, strand, s);
    sprite.radius *= std::min(1.0, inside);
    draw(sprite, slice);
    cover += std::numbers::pi * sprite.radius * sprite.radius / (slice_texels * slice_texels);
  }
  return slice;
}

}  // namespace

Slices bake_slices(const Coat& coat, const std::function<bool()>& go_on) {
  const std::vector<Strand> strands = make_strands(coat);
  const StackLight light = light_from_above(coat, strands);
  std::vector<std::vector<SliceTexel>> stack(slice_count);
  std::atomic<bool> stopped = false;  // stays true whatever `go_on` returns later, because a slice is missing
  // Slices are independent, so the number of threads changes no bit. Two threads leave the other cores to drawing.
  for_each_in_parallel(
      slice_count,
      [&](std::uint32_t i) {
        if (go_on && !go_on()) stopped = true;
        if (stopped) return;
        stack[i] = bake_slice(coat, strands, static_cast<int>(i));
        set_light(light.cells[i], stack[i]);
      },
      2);
  if (stopped || (go_on && !go_on())) return {};
  return {build_levels(coat, strands, std::move(stack)), light.depth_above};
}

Slices without_texels(const Slices& slices) {
  Slices rest{{}, slices.depth_above};
  for (const SliceLevel& level : slices.levels) rest.levels.push_back({level.texels, {}, {}, level.depth_scale});
  return rest;
}

std::shared_ptr<const Slices> bake_here(const Coat& coat) { return std::make_shared<const Slices>(bake_slices(coat)); }

namespace {

/// Returns the number of texels of all slices of the first levels.
std::size_t texels_of(int levels) {
  std::size_t texels = 0;
  for (std::size_t level = 0, side = slice_texels; level < static_cast<std::size_t>(levels); ++level, side /= 2)
    texels += side * side * slice_count;
  return texels;
}

}  // namespace

std::size_t slices_bytes() { return 8 * texels_of(slice_levels); }

std::size_t baking_bytes() {
  const std::size_t halving = 2 * 2 * slice_texels * slice_texels;  // on each of two threads
  return sizeof(SliceTexel) * (texels_of(3) + halving) + slices_bytes();
}

std::array<glm::vec3, slice_count> colour_above(const Coat& coat) {
  std::array<glm::vec3, slice_count> result{};
  glm::dvec3 sum(0);
  for (int i = slice_count - 1; i >= 0; --i) {
    const glm::dvec3 here(ramp_colour(coat, (i + 0.5) / slice_count));
    sum += here;
    const glm::dvec3 mean = sum / static_cast<double>(slice_count - i);
    result[static_cast<std::size_t>(i)] = glm::clamp((mean + 1e-6) / (here + 1e-6), 0.0, 100.0);
  }
  return result;
}

}  // namespace pelage
