// Shadow that one part of the body casts on another (GPU fur 4): depth map, inverted occlusion map, shadow-width map.
#pragma once

#include <string>

#include "renderer/gl/handles.h"
#include "renderer/gl/program.h"
#include "renderer/upload/blocks.h"
#include "renderer/upload/model_buffers.h"

namespace pelage {

/// Where the three maps are drawn, one light after the other. Depth and occlusion are of the maps' size; that of the
/// widths divides it.
struct SceneShadowTargets {
  const RenderTarget &depth, &occlusion, &width;  // R32F with depth buffer, RG32F, RG32F
};

class SceneShadowPass {
 public:
  explicit SceneShadowPass(const Gl& gl);

  std::string failure() const { return depth_.log() + hull_.log() + occlusion_.log() + width_.log(); }

  /// The frame block of the light's view and the model's vertex array are bound.
  void draw(const Gl& gl, const ModelBuffers::DrawList& triangles, const LightView& light,
            const SceneShadowTargets& targets) const;

  /// Draws the linear depth of the fur's hull (renderer/shaders/lean.glsl), which occludes fur elsewhere, into a target
  /// of R32F with depth.
  void draw_hull(const Gl& gl, const ModelBuffers::DrawList& triangles, const LightView& light,
                 const RenderTarget& target) const;

 private:
  static void draw_depths(const Gl& gl, const Program& program, const ModelBuffers::DrawList& triangles,
                          const LightView& light, const RenderTarget& target);
  void draw_occlusion(const Gl& gl, const ModelBuffers::DrawList& triangles, const LightView& light,
                      const SceneShadowTargets& targets) const;

  Program depth_, hull_, occlusion_, width_;
};

}  // namespace pelage
