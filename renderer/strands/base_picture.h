// What lies under the fur, drawn by the shells' passes: skin, bare skin and eyes in the light of all lights, without
// fur, shadows and ground.
#pragma once

#include "renderer/image/float_image.h"

namespace pelage {

/// Pictures of one size, which is a whole multiple of the frame's; conventions of Renderer::draw_layers.
struct BasePicture {
  FloatImage beauty;  // multiplied by alpha, which is 0 where there is neither skin nor eye
  FloatImage direct;  // of that the part of lights
  FloatImage albedo;
  FloatImage normal;
  FloatImage depth;  // 1 / distance along the view, 1 / sizes; 0 for none
};

}  // namespace pelage
