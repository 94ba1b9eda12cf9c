// The strands of the periodic tile by where they stand: which of them fall into a triangle of the plane.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/coat/strand_tile.h"

namespace pelage {

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

  /// Of the strands a share, by a number of their own.
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
