// Strands that stand together, as one: what a card of hair is laid along.
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "server/export/strands.h"

namespace pelage {

/// What a card is laid along: the mean of the strands of a clump, at even steps from root to tip.
struct CardLine {
  static constexpr std::size_t rows = 6;

  std::array<glm::vec3, rows> places{};   // internal
  std::array<glm::vec3, rows> colours{};  // linear
  glm::vec3 normal{0, 1, 0};              // of the skin, unit
  float number = 0;                       // [0, 1), its first strand's
};

/// The fur of the strands, gathered by the cubes with sides of `cell` sizes that their roots lie in, and by the side
/// that the skin faces there, so that the two sides of an ear stay apart. In an order that depends on nothing but the
/// strands.
std::vector<CardLine> make_clumps(const ExportedStrands& strands, double cell);

/// The sides of cubes that make about `count` clumps, within a tenth where that can be had.
double cell_of(const ExportedStrands& strands, int count);

}  // namespace pelage
