// The eyes of a frame, as renderer/optics reads them.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "renderer/input/fur_scene.h"
#include "renderer/shaders/constants.h"

namespace pelage {

struct EyeEntry {
  glm::vec4 right{0}, up{0}, forward{0}, position{0}, cornea{0}, iris{0}, inner{0}, pupil{0}, sclera{0};
  glm::vec4 lid_right{0}, lid_up{0}, lid_facing{0}, lid{0};
};

struct EyeBlock {
  glm::vec4 surroundings{0};
  std::array<EyeEntry, max_eyes> eyes{};
};
static_assert(sizeof(EyeBlock) == 16 * (1 + 8 * 13));

/// `first_caustic` is the array index at which the caustics of the eye's shape begin. A pupil without a size answers
/// the frame's lights.
EyeEntry make_eye_entry(const FurEye& eye, const FurFrame& frame, int first_caustic);

}  // namespace pelage
