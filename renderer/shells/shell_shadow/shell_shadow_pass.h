// Shadow maps of the shells (GPU fur 3.1): for each boundary between shells, the share of light that got there.
#pragma once

#include <map>
#include <string>

#include "renderer/gl/handles.h"
#include "renderer/gl/program.h"
#include "renderer/shaders/constants.h"
#include "renderer/upload/model_buffers.h"

namespace pelage {

inline constexpr int shadow_boundaries = shadow_shells + 1;  // the skin first, the open air last

class ShellShadowPass {
 public:
  explicit ShellShadowPass(const Gl& gl);

  /// "" when the programs of all variants so far were built.
  std::string failure() const { return failure_; }

  /// Writes shadow_boundaries slices of `maps` (R16F) from `first_slice` on. The frame block of the light's view, the
  /// model's vertex array, the coat's textures and what the variant reads (#define lines: PATTERN, TUFTS) are bound.
  /// `target` is R16F with depth and of the maps' size.
  void draw(const Gl& gl, const std::string& variant, const ModelBuffers::DrawList& triangles,
            const RenderTarget& target, GLuint maps, int first_slice);

 private:
  const Program& program_of(const Gl& gl, const std::string& variant);

  Program skin_;
  std::map<std::string, Program> programs_;  // by variant, made when first used
  std::string failure_;
};

}  // namespace pelage
