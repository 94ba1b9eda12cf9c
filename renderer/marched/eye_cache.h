// What eyes keep between frames, made when the first one is drawn.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "renderer/eye/optics.h"
#include "renderer/marched/march_scene.h"

namespace pelage {

class EyeCache {
 public:
  EyeCache();

  /// Adds a frame's eyes, 1 to 8, to its scene, whose camera is there. Valid until the next call.
  void add(const FurFrame& frame, MarchScene& scene);

 private:
  int first_caustic_of(const EyeShape& shape);

  TissueLevels tissues_;
  std::vector<EyeShape> shapes_;  // whose caustics are kept, in this order
  std::vector<float> caustics_;
};

}  // namespace pelage
