// Parts of the picture that balls may cover.
#pragma once

#include <glm/glm.hpp>
#include <optional>

namespace pelage {

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

ClipBox union_of(const std::optional<ClipBox>& a, const ClipBox& b);

}  // namespace pelage
