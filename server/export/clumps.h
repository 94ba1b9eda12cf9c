// Combines neighbouring strands to clumps, along which hair cards are laid.
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "server/export/strands.h"

namespace pelage {

/// The middle line of a card: the mean of the strands of a clump, at even steps from root to tip.
struct CardLine {
  static constexpr std::size_t rows = 6;

  std::array<glm::vec3, rows> positions{};  // positions, internal
  std::array<glm::vec3, rows> colours{};    // linear
  glm::vec3 normal{0, 1, 0};                // of the skin, unit
  float number = 0;                         // random number of its first strand, [0, 1)
  std::size_t coat = 0;                     // index in ExportedStrands::groups
};

/// Returns the clumps of the fur, coat by coat. A clump has the strands of one coat with roots in one cube with sides
/// of `cell` sizes, where the skin faces the same of six directions, so that the two sides of an ear stay apart. The
/// order is deterministic.
std::vector<CardLine> make_clumps(const ExportedStrands& strands, double cell);

/// Returns the side of the cubes, in sizes, that gives about `count` clumps, within a tenth if possible.
double cell_of(const ExportedStrands& strands, int count);

}  // namespace pelage
