// Eyes of a frame as they are drawn: what is kept between frames, made when the first one is drawn.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/eye/iris_map.h"
#include "renderer/eye/optics.h"
#include "renderer/input/picture.h"

namespace pelage {

/// The tissue of an iris and a sclera (make_iris_map) with its mip levels, four bytes a word.
struct TissueLevels {
  std::vector<std::int32_t> words;
  std::array<std::int32_t, iris_map_levels> first{};  // word of each level
};
static_assert(iris_map_height >> (iris_map_levels - 1) == 1);

/// Views that outlive the frame's drawing.
struct EyeOptics {
  EyeBlock block;
  int steps = 0;                          // into the iris: Knobs::eye_steps
  const TissueLevels* tissues = nullptr;  // not null where there are eyes
  std::span<const float> caustics;        // gather_caustics of each shape, one after the other
};

/// The camera in the frame of an eye.
struct EyeCamera {
  glm::vec3 viewer{0};   // radii of the eye
  glm::vec3 forward{0};  // unit
  PixelBox box;          // that the eye may touch
};

/// On a picture of `size` pixels.
EyeCamera eye_camera(const EyeEntry& eye, const FurCamera& camera, const glm::mat4& world_to_clip, glm::ivec2 size);

class EyeCache {
 public:
  EyeCache();

  /// Of a frame's eyes, 1 to 8. Views into this object, until the next call.
  EyeOptics of(const FurFrame& frame);

 private:
  int first_caustic_of(const EyeShape& shape);

  TissueLevels tissues_;
  std::vector<EyeShape> shapes_;  // whose caustics are kept, in this order
  std::vector<float> caustics_;
};

}  // namespace pelage
