// How much fur is drawn where on the picture, estimated from its triangles, so that a long frame can be cut into pieces
// that take about as long.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "renderer/visibility/shell_lod.h"

namespace pelage {

/// In fragments; a triangle of a shell counts as a few.
class FurWork {
 public:
  /// None anywhere.
  FurWork() = default;
  /// Of the triangles that reach the view's part of a picture of so many pixels. A guess: it may be off by a few times,
  /// by about as much everywhere.
  FurWork(const ShellMesh& mesh, const ShellView& view, glm::ivec2 pixels);

  /// In a box in [0, 1], from the left and from below.
  double in(const glm::dvec2& low, const glm::dvec2& high) const;

 private:
  void add(const CellBox& reached, double work);

  std::array<double, cells_a_side * cells_a_side> cells_{};  // rows from below
};

}  // namespace pelage
