// The optics of a frame's eyes, with data that is cached between frames and made when first needed.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/eye/iris_map.h"
#include "renderer/eye/optics.h"
#include "renderer/input/picture.h"

namespace pelage {

/// The tissue of an iris and a sclera (make_iris_map) with its mip levels; a texel is four bytes in a word.
struct TissueLevels {
  std::vector<std::int32_t> words;
  std::array<std::int32_t, iris_map_levels> first{};  // first word of each level
};
static_assert(iris_map_height >> (iris_map_levels - 1) == 1);

/// The views must outlive the drawing of the frame.
struct EyeOptics {
  EyeBlock block;
  int steps = 0;                          // steps of the march into the iris: Knobs::eye_steps
  const TissueLevels* tissues = nullptr;  // not null if there are eyes
  std::span<const float> caustics;        // gather_caustics of each shape, one after the other
};

/// The camera in the frame of an eye.
struct EyeCamera {
  glm::vec3 viewer{0};   // position, radii of the eye
  glm::vec3 forward{0};  // view direction, unit
  PixelBox box;          // pixels that the eye may touch
};

/// Returns the camera for an eye, for a picture of `size` pixels.
EyeCamera eye_camera(const EyeEntry& eye, const FurCamera& camera, const glm::mat4& world_to_clip, glm::ivec2 size);

class EyeCache {
 public:
  EyeCache();

  /// Returns the optics of a frame's 1 to 8 eyes. Its views point into this object and are valid until the next call.
  EyeOptics of(const FurFrame& frame);

 private:
  int first_caustic_of(const EyeShape& shape);

  TissueLevels tissues_;
  std::vector<EyeShape> shapes_;  // the shapes whose caustics are cached, in this order
  std::vector<float> caustics_;
};

}  // namespace pelage
