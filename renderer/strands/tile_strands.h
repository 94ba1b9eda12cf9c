// The strands of a coat's sample tile, with the per-knot data that does not depend on where the tile lies, and the
// lookup of strands by position.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/coat/strand_tile.h"

namespace pelage {

/// Returns the number of segments that the coat's strands need, [6, 48]: up to 8 for each turn of its curl or period of
/// its wave. `curled`: curl is painted as well.
int strand_segments(const Coat& coat, bool curled);

class TileStrands {
 public:
  TileStrands(const Coat& coat, int segments);

  int segments() const { return segments_; }
  std::span<const Strand> strands() const { return strands_; }
  const Strand& operator[](std::uint32_t strand) const { return strands_[strand]; }
  /// Returns the position of knot k along the strand, [0, 1].
  float along(int k) const { return static_cast<float>(k) / static_cast<float>(segments_); }
  /// Returns strand_offset() at each knot.
  std::span<const glm::vec2> offsets(std::uint32_t strand) const {
    const auto knots = static_cast<std::size_t>(segments_) + 1;
    return std::span(offsets_).subspan(strand * knots, knots);
  }
  /// Returns strand_colour() at a knot.
  glm::vec3 colour(std::uint32_t strand, int k) const;
  /// Returns the knot whose colour stands for the strand's visible part; below it the strand is hidden in the fur.
  int seen_knot() const { return 2 * segments_ / 3; }
  /// Returns the mean colour at that knot over strands of similar length, weighted by coverage.
  glm::vec3 mean_colour(std::uint32_t strand) const;
  /// Returns the radius at a knot, sizes.
  float radius(std::uint32_t strand, int k) const;
  /// Returns the mean luminance of strands at a height s in [0, 1] of the fur, weighted by coverage.
  float mean_luminance(float s) const;

  std::uint64_t hash() const;

 private:
  void find_means(const Coat& coat);
  void find_seen_means();

  int segments_;
  std::vector<Strand> strands_;
  std::vector<glm::vec3> own_colours_;  // Strand::own_colour, darkened by the coat's wetness
  std::vector<glm::vec2> offsets_;      // for each strand and knot
  std::vector<glm::vec3> ramp_;         // by knot
  std::vector<float> radii_;            // by knot, for strands of width 1
  std::vector<float> means_;            // luminance, by height
  std::vector<glm::vec3> seen_means_;   // colour at seen_knot(), by length
};

// Finds the strands of the periodic tile that fall into a triangle of the plane.

/// A copy of a tile's strand, moved by whole tiles.
struct TileCopy {
  std::uint32_t strand = 0;
  glm::ivec2 tiles{0};  // number of tiles that it was moved by
  glm::dvec3 share{0};  // barycentric coordinates in the triangle
};

class HalfOpenTriangle;

class TileCells {
 public:
  static constexpr double furthest = 100;              // sizes from the origin; triangles beyond it have no strands
  static constexpr std::size_t max_copies = 1u << 22;  // limit for one triangle; further copies are left out

  /// Builds the grid over a share of the strands, chosen by a random number of each.
  TileCells(std::span<const Strand> strands, double tile, double share = 1);

  /// Sets `found` to the copies inside a triangle of the plane, in sizes. Triangles are half open: of two triangles on
  /// both sides of a shared edge, each copy is in exactly one. Finds none if the area is 0 or a corner is not finite.
  /// Takes time in proportion to the number of copies and of cells along the edges.
  void find(const std::array<glm::dvec2, 3>& triangle, std::vector<TileCopy>& found) const;

 private:
  void find_in_cell(std::int64_t x, std::int64_t y, const HalfOpenTriangle& triangle,
                    std::vector<TileCopy>& found) const;

  double tile_;
  std::int64_t side_;                 // cells along a side
  std::vector<std::uint32_t> first_;  // first index of each cell in the two arrays below; one more at the end
  std::vector<std::uint32_t> strands_;
  std::vector<glm::dvec2> roots_;  // sizes
};

}  // namespace pelage
