// Overlays for inspection: fields as colours over a frame, and the bare shape of a model.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "renderer/image/float_image.h"
#include "renderer/input/fur_scene.h"

namespace pelage {

/// Returns true if an overlay shows a field: a painted or combed one, strokes along the fur, or the difference.
bool is_field(Overlay overlay);

/// The values of fields at a vertex.
struct FieldVertex {
  glm::vec3 position{0}, normal{0, 1, 0}, tangent{1, 0, 0};
  glm::vec2 direction{0};
  float length = 0;  // sizes
  float density = 1, wetness = 0, mask = 1;
  std::uint32_t model_vertex = 0;  // index into FurFrame::difference
};

/// Evaluates what a vertex shows, for a frame whose overlay is a field. x and y: lean in the picture, or one number in
/// x. z: 1 if it is shown, else 0.
class FieldValues {
 public:
  /// `longest`: length of the longest fur, sizes.
  FieldValues(const FurFrame& frame, float longest);
  glm::vec3 of(const FieldVertex& vertex) const;

 private:
  glm::vec2 number_of(const FieldVertex& vertex) const;

  const FurFrame& frame_;
  glm::mat4 to_clip_;
  float longest_;
};

/// Returns the frame's overlay, sRGB with straight alpha. `seen` has for each pixel, row by row, the value there, and
/// the share of the pixel that shows it.
FloatImage field_picture(const FurFrame& frame, const std::vector<glm::vec3>& seen, int threads);

// The bare shape of a model, which replaces a frame, to find positions on the model.

/// Returns Overlay::bald or wire at the frame's size; opaque. It shows the skin in plain grey, lit from the camera, and
/// for wire the edges of its triangles. For each pixel, row by row, `normals` has the normal of the visible skin and 1,
/// or 0 where there is none; the first number of `triangle_ids` is the index of the model's triangle there.
FloatImage shape_picture(const FurFrame& frame, const FurModel& model, const FloatImage& normals,
                         const FloatImage& triangle_ids, int threads);

}  // namespace pelage
