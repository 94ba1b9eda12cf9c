// What the look's shading model reads on the GPU: its numbers, and for the fibre models a table.
#pragma once

#include <optional>

#include "renderer/gl/handles.h"
#include "renderer/input/fur_scene.h"

namespace pelage {

/// Made anew when the look or the coat's wetness changes.
class ScatteringTextures {
 public:
  explicit ScatteringTextures(const Gl& gl) : block_(gl) {}

  /// Leaves the uniform block at binding 3 and the table, where there is one, at texture unit 3.
  void prepare(const Gl& gl, const FurFrame& frame);

 private:
  Buffer block_;
  Texture table_;
  std::optional<Look> look_;
};

}  // namespace pelage
