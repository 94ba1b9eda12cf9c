#include "renderer/coat/strand_cover.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

namespace pelage {

namespace {

constexpr int ray_side = 512;      // rays on a side of the tile; a power of 2
constexpr int parts_of_slice = 2;  // each with a constant radius
constexpr double crossed_slice = nominal_length / slice_count;

double radius_at(const Coat& coat, const Strand& strand, double q) {
  return 0.5 * strand.width * glm::mix(coat.width_root, coat.width_tip, q);
}

/// The part of a strand in a slice, by the offsets from its root.
struct Stretch {
  double low = 0, high = 0;  // along the strand, [0, 1]
  glm::dvec2 from{0}, to{0};

  glm::dvec2 at(double q) const { return glm::mix(from, to, (q - low) / std::max(high - low, 1e-9)); }
};

Stretch stretch_of(const Coat& coat, const Strand& strand, int slice) {
  const double low = std::min(1.0, slice / (slice_count * strand.length_share));
  const double high = std::min(1.0, (slice + 1) / (slice_count * strand.length_share));
  return {low, high, strand_offset(coat, strand, low), strand_offset(coat, strand, high)};
}

/// Rays, indexed by their tile position at the height 0: 1 for those that nothing has stopped, and their number.
struct Rays {
  std::vector<std::uint8_t> passing = std::vector<std::uint8_t>(ray_side * ray_side, 1);
  int left = ray_side * ray_side;

  /// Stops the rays that a disc hits while it moves from one position to another: slanted rays would slip between the
  /// fixed discs of thin strands.
  void stop(glm::dvec2 from, glm::dvec2 to, double radius) {
    const glm::dvec2 segment = to - from;
    const double square = std::max(glm::dot(segment, segment), 1e-12);
    const glm::ivec2 low(glm::ceil(glm::min(from, to) - radius - 0.5)),
        high(glm::floor(glm::max(from, to) + radius - 0.5));
    for (int y = low.y; y <= high.y; ++y) {
      for (int x = low.x; x <= high.x; ++x) {
        std::uint8_t& ray = passing[static_cast<std::size_t>((y & (ray_side - 1)) * ray_side + (x & (ray_side - 1)))];
        if (ray == 0) continue;
        const glm::dvec2 at = glm::dvec2(x + 0.5, y + 0.5) - from;
        const glm::dvec2 apart = at - std::clamp(glm::dot(at, segment) / square, 0.0, 1.0) * segment;
        if (glm::dot(apart, apart) > radius * radius) continue;
        --left, ray = 0;
      }
    }
  }
};

void cut_slice(const Coat& coat, const std::vector<Strand>& strands, int slice, double tangent, Rays& rays) {
  const double to_rays = ray_side / coat.tile;
  for (const Strand& strand : strands) {
    if (rays.left == 0) return;
    const Stretch stretch = stretch_of(coat, strand, slice);
    const auto among_rays = [&](double at) {  // `at`: height within the slice, [0, 1]
      const double s = (slice + at) / slice_count, q = s / strand.length_share;
      return (strand.root + stretch.at(q) - glm::dvec2(tangent * nominal_length * s, 0)) * to_rays;
    };
    const double end = std::min(1.0, slice_count * strand.length_share - slice);
    for (int part = 0; part < parts_of_slice && end > 0; ++part) {
      const double low = end * part / parts_of_slice, high = end * (part + 1) / parts_of_slice;
      const double q = (slice + (low + high) / 2) / (slice_count * strand.length_share);
      rays.stop(among_rays(low), among_rays(high), radius_at(coat, strand, q) * to_rays);
    }
  }
}

}  // namespace

std::array<double, slice_count> ray_transmittance(const Coat& coat, const std::vector<Strand>& strands,
                                                  double tangent) {
  std::array<double, slice_count> result{};
  Rays rays;
  for (int slice = slice_count - 1; slice >= 0; --slice) {
    cut_slice(coat, strands, slice, tangent, rays);
    result[static_cast<std::size_t>(slice)] = static_cast<double>(rays.left) / (ray_side * ray_side);
  }
  return result;
}

CrossingGrid crossings_of(const Coat& coat, const std::vector<Strand>& strands) {
  const double cell = coat.tile / crossing_cells;
  CrossingGrid grid;
  for (int slice = 0; slice < slice_count; ++slice) {
    std::vector<double>& cells = grid[static_cast<std::size_t>(slice)];
    cells.assign(crossing_cells * crossing_cells, 0.0);
    const double s = (slice + 0.5) / slice_count;
    for (const Strand& strand : strands) {
      const double q = s / strand.length_share;
      if (q > 1) continue;
      const glm::ivec2 at(glm::floor((strand.root + strand_offset(coat, strand, q)) / cell));
      const int x = at.x & (crossing_cells - 1), y = at.y & (crossing_cells - 1);
      cells[static_cast<std::size_t>(y * crossing_cells + x)] +=
          2 * radius_at(coat, strand, q) * crossed_slice / (cell * cell);
    }
  }
  return grid;
}

}  // namespace pelage
