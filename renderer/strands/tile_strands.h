// The strands of a coat's tile with what does not depend on where they stand: worked out once for each knot.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/coat/strand_tile.h"

namespace pelage {

/// Segments that the forms of a coat's strands need, [6, 48]: 8 to a turn of its curl, or to a wave. `curled` where
/// curl is painted as well.
int strand_segments(const Coat& coat, bool curled);

class TileStrands {
 public:
  TileStrands(const Coat& coat, int segments);

  int segments() const { return segments_; }
  std::span<const Strand> strands() const { return strands_; }
  const Strand& operator[](std::uint32_t strand) const { return strands_[strand]; }
  /// Of knot k: share of the way along the strand, [0, 1].
  float along(int k) const { return static_cast<float>(k) / static_cast<float>(segments_); }
  /// strand_offset() at each knot.
  std::span<const glm::vec2> offsets(std::uint32_t strand) const {
    const auto knots = static_cast<std::size_t>(segments_) + 1;
    return std::span(offsets_).subspan(strand * knots, knots);
  }
  /// strand_colour() at a knot.
  glm::vec3 colour(std::uint32_t strand, int k) const;
  /// Returns the knot whose colour is visible; below it the strand is hidden in the fur.
  int seen_knot() const { return 2 * segments_ / 3; }
  /// Returns the mean colour at that knot of strands about as long as this one, weighted by what they cover.
  glm::vec3 mean_colour(std::uint32_t strand) const;
  /// Returns the radius at a knot, sizes.
  float radius(std::uint32_t strand, int k) const;
  /// Returns the mean luminance of strands at a height of the fur in [0, 1], weighted by what they cover.
  float mean_luminance(float s) const;

  std::uint64_t hash() const;

 private:
  void find_means(const Coat& coat);
  void find_seen_means();

  int segments_;
  std::vector<Strand> strands_;
  std::vector<glm::vec3> own_colours_;  // as water leaves them
  std::vector<glm::vec2> offsets_;      // of each strand, by knot
  std::vector<glm::vec3> ramp_;         // by knot
  std::vector<float> radii_;            // by knot, of strands of width 1
  std::vector<float> means_;            // by height
  std::vector<glm::vec3> seen_means_;   // by length
};

// The strands of the periodic tile by where they stand: which of them fall into a triangle of the plane.

/// A strand of the tile moved by whole tiles.
struct TileCopy {
  std::uint32_t strand = 0;
  glm::ivec2 tiles{0};  // by how many it was moved
  glm::dvec3 share{0};  // barycentric coordinates in the triangle
};

class HalfOpenTriangle;

class TileCells {
 public:
  static constexpr double furthest = 100;              // sizes; triangles that reach further have no strands
  static constexpr std::size_t max_copies = 1u << 22;  // of one triangle; what is beyond them is left out

  /// Indexes a share of the strands, chosen by a random number of each.
  TileCells(std::span<const Strand> strands, double tile, double share = 1);

  /// Replaces `found` by the copies inside a triangle on the plane, sizes. Half open: of triangles that share an edge
  /// and lie on both sides of it, each copy falls into one. None where the area is 0 or a corner is not finite.
  /// Takes about as long as there are copies and cells along the edges.
  void find(const std::array<glm::dvec2, 3>& triangle, std::vector<TileCopy>& found) const;

 private:
  void find_in_cell(std::int64_t x, std::int64_t y, const HalfOpenTriangle& triangle,
                    std::vector<TileCopy>& found) const;

  double tile_;
  std::int64_t side_;                 // cells
  std::vector<std::uint32_t> first_;  // of each cell, in the two below; one more at the end
  std::vector<std::uint32_t> strands_;
  std::vector<glm::dvec2> roots_;  // sizes
};

}  // namespace pelage
