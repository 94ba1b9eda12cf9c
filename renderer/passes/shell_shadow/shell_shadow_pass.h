// Layer-wise shadow maps (GPU fur 3.1): for each boundary between layers, the share of light that got there.
#pragma once

#include <string>

#include "renderer/gl/program.h"
#include "renderer/gl/render_target.h"
#include "renderer/upload/model_buffers.h"

namespace pelage {

inline constexpr int shadow_layers = 16;                     // as in the paper
inline constexpr int shadow_boundaries = shadow_layers + 1;  // the skin first, the open air last

class ShellShadowPass {
 public:
  explicit ShellShadowPass(const Gl& gl);

  std::string failure() const { return skin_.log() + layer_.log(); }

  /// Writes shadow_boundaries slices of `maps` (R16F) from `first_slice` on. The frame block of the light's view, the
  /// model's vertex array and the coat's textures are bound. `target` is R16F with depth and of the maps' size.
  void draw(const Gl& gl, const ModelBuffers::DrawList& triangles, const RenderTarget& target, GLuint maps,
            int first_slice) const;

 private:
  Program skin_, layer_;
};

}  // namespace pelage
