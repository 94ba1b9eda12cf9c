// Draws the shadow maps of the shells (GPU fur 3.1): for each boundary between shells, the transmittance from the light
// to it.
#pragma once

#include <map>
#include <string>

#include "renderer/gl/handles.h"
#include "renderer/gl/program.h"
#include "renderer/shaders/constants.h"
#include "renderer/upload/model_buffers.h"

namespace pelage {

inline constexpr int shadow_boundaries = shadow_shells + 1;  // from the skin to above the last shell

class ShellShadowPass {
 public:
  explicit ShellShadowPass(const Gl& gl);

  /// Returns why programs could not be built; "" if those of all variants so far were.
  std::string failure() const { return failure_; }

  /// Writes shadow_boundaries slices of the texture array `maps` (R16F) from `first_slice` on. The frame block of the
  /// light's view, the model's vertex array, the coat's textures and what the variant (#define lines: PATTERN, TUFTS)
  /// reads have to be bound. `target` is R16F with depth, of the maps' size.
  void draw(const Gl& gl, const std::string& variant, const ModelBuffers::DrawList& triangles,
            const RenderTarget& target, GLuint maps, int first_slice);

 private:
  const Program& program_of(const Gl& gl, const std::string& variant);

  Program skin_;
  std::map<std::string, Program> programs_;  // by variant, made when first used
  std::string failure_;
};

}  // namespace pelage
