// Where on the picture fur may show, so that what does not reach a part of it is not drawn there.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

namespace pelage {

inline constexpr int cells_a_side = 48;  // of the picture

/// Cells of the picture from the left and from below, last ones included; -1 and cells_a_side are all that lies
/// outside. Empty never: what lies behind the eye counts as everywhere. All of the picture at first.
struct CellBox {
  int left = 0, low = 0, right = cells_a_side - 1, high = cells_a_side - 1;

  bool operator==(const CellBox&) const = default;
};

/// A part of the picture in [-1, 1], from the left and from below; all of it at first.
struct ClipBox {
  glm::vec2 low{-1}, high{1};
};

/// Of balls, as a camera sees them.
class BallBoxes {
 public:
  explicit BallBoxes(const glm::mat4& to_clip);
  /// All of the picture for a ball that reaches behind the eye.
  ClipBox of(glm::vec3 middle, float radius) const;

 private:
  glm::mat4 to_clip_;
  glm::vec2 scale_;  // how far a unit across the view moves on the picture at distance 1
};

ClipBox union_of(const ClipBox& a, const ClipBox& b);
ClipBox union_of(const std::optional<ClipBox>& a, const ClipBox& b);
CellBox cells_of(const ClipBox& box);

/// For each vertex the cells that its fur may reach: a ball about the root. Lengths in the unit of the positions; fur
/// is up to `stretch` times as long.
std::vector<CellBox> cells_of_fur(const glm::mat4& to_clip, std::span<const glm::vec3> positions,
                                  std::span<const float> lengths, float stretch = 1);

CellBox union_of(const CellBox& a, const CellBox& b);
CellBox union_of(const CellBox& a, const CellBox& b, const CellBox& c);
bool touch(const CellBox& a, const CellBox& b);

}  // namespace pelage
