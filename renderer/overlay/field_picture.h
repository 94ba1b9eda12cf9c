// Fields as colours over a frame, for inspection.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "renderer/image/float_image.h"
#include "renderer/input/fur_scene.h"

namespace pelage {

/// Returns whether an overlay shows a field: one that is painted or combed, strokes along the fur, or the difference.
bool is_field(Overlay overlay);

/// What fields say at a vertex.
struct FieldVertex {
  glm::vec3 position{0}, normal{0, 1, 0}, tangent{1, 0, 0};
  glm::vec2 direction{0};
  float length = 0;  // sizes
  float density = 1, wetness = 0, mask = 1;
  std::uint32_t model_vertex = 0;  // of FurFrame::difference
};

/// What a vertex is coloured by, for a frame whose overlay is a field: a lean on the picture, or one number, in the
/// first two, and 1 where it is shown, else 0.
class FieldValues {
 public:
  /// `longest`: length of the longest fur of all, sizes.
  FieldValues(const FurFrame& frame, float longest);
  glm::vec3 of(const FieldVertex& vertex) const;

 private:
  glm::vec2 number_of(const FieldVertex& vertex) const;

  const FurFrame& frame_;
  glm::mat4 to_clip_;
  float longest_;
};

/// The frame's overlay by what is seen at each pixel of a picture of its size, row by row: the value there, and how
/// much of the pixel shows it. sRGB with straight alpha.
FloatImage field_picture(const FurFrame& frame, const std::vector<glm::vec3>& seen, int threads);

// The bare shape of a model in place of a frame, to find places on it.

/// Overlay::bald or wire at the frame's size, which it hides: the skin in plain grey, lit from the camera, and for wire
/// the edges of its triangles. Of each pixel, row by row, `normals` has the normal of the skin that is seen and 1, 0
/// where there is none; the first number of `pieces` that of its piece of the model.
FloatImage shape_picture(const FurFrame& frame, const FurModel& model, const FloatImage& normals,
                         const FloatImage& pieces, int threads);

}  // namespace pelage
