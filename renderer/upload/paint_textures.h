// What shaders must know of a coat to draw painted fields on it.
#pragma once

#include <optional>

#include "renderer/coat/clump_map.h"
#include "renderer/gl/handles.h"

namespace pelage {

/// Made anew when the coat's clumps change.
class PaintTextures {
 public:
  explicit PaintTextures(const Gl& gl) : uniforms_(gl) {}

  /// Leaves PaintBlock (renderer/shaders/paint.glsl) at binding 6 and the map of clumps at texture unit 15.
  void prepare(const Gl& gl, const Coat& coat);

 private:
  Buffer uniforms_;
  Texture clumps_;
  std::optional<Coat> coat_;
};

}  // namespace pelage
