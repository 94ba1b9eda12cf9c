// Where on the picture each set of layers may show, so that a set's triangles are drawn only there.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace pelage {

/// Cells of the picture, last ones included. Empty never: what lies behind the eye counts as everywhere.
struct CellBox {
  int left = 0, top = 0, right = 0, bottom = 0;
};

class SetCells {
 public:
  static constexpr int side = 48;  // cells along each side of the picture

  void show(const CellBox& box, int set);
  bool may_show(const CellBox& box, int set) const;

 private:
  std::array<std::uint8_t, side * side> sets_{};  // a bit for each
};

/// For each vertex the cells that its fur may reach: a ball about the root. Lengths in the unit of the positions.
std::vector<CellBox> cells_of_fur(const glm::mat4& to_clip, std::span<const glm::vec3> positions,
                                  std::span<const float> lengths);

CellBox union_of(const CellBox& a, const CellBox& b, const CellBox& c);

}  // namespace pelage
