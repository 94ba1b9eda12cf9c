// What a view of furred skin has that decides cost and error, told without drawing.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/input/fur_scene.h"

namespace pelage {

/// The skin as it is drawn. Fur over vertices, `length` in sizes.
struct FurredSkin {
  std::span<const glm::vec3> positions, normals;
  std::span<const glm::uvec3> triangles;
  std::span<const float> length;  // for each vertex
  double pieces = 1;              // pieces of fur for each triangle, 1 or more
  bool painted = false;           // whether any field beside direction and length is
};

/// Pixels are those of the asked size. All finite.
struct ViewFeatures {
  double pixels = 1;         // of the picture
  double triangles = 0;      // pieces, drawn or not
  double visible = 0;        // pieces whose shells are drawn
  double area = 0;           // pixels that those pieces cover inside the picture, one over the other
  double edges = 0;          // pixels along their sides inside the picture
  double covered = 0;        // pixels that any of them covers
  double behind = 0;         // share of `area` that lies well behind other fur, [0, 1]
  double fur_pixels = 0;     // length of the fur where it is seen
  double strand_pixels = 0;  // width of a strand at its root, the same
  double bending = 0;        // of the skin over the length of its fur, radians
  double lightness = 0;      // of the coat, [0, 1]
  double lights = 0;
  bool scatters = false;  // shading by a model of fibres
  bool varies = false;    // pattern, tufts or paint
  std::vector<glm::vec2> places =
      {};  // pixels from the left and the top, at most six: fur, evenly over all that is seen
};

/// At most some ten thousand triangles are looked at, evenly through the list. Deterministic.
ViewFeatures view_features(const FurFrame& frame, const FurredSkin& skin);

// Small parts of a view, drawn as pictures of their own with pixels of the same size.

/// The frame's fur before nothing: no ground, no overlay.
FurFrame fur_alone(FurFrame frame);

/// Pixels a side of a part of a picture of that size.
int window_side(int width, int height);

/// What the frame shows about a place of its picture (pixels from the left and the top), its fur alone. The camera
/// turns towards the place, so strands are seen from their side of the view and as large as there.
FurFrame window_of(const FurFrame& frame, glm::vec2 place, int side);

}  // namespace pelage
