// Draws the maps for shadows that one part of the body casts on another (GPU fur 4): depth map, inverted occlusion map,
// shadow-width map.
#pragma once

#include <string>

#include "renderer/gl/handles.h"
#include "renderer/gl/program.h"
#include "renderer/upload/blocks.h"
#include "renderer/upload/model_buffers.h"

namespace pelage {

/// Targets of the three maps of a light. Depth and occlusion have the same size, a multiple of the width map's.
struct SceneShadowTargets {
  const RenderTarget &depth, &occlusion, &width;  // R32F with depth buffer, RG32F, RG32F
};

class SceneShadowPass {
 public:
  explicit SceneShadowPass(const Gl& gl);

  /// Returns why programs could not be built; "" if all were.
  std::string failure() const { return depth_.log() + hull_.log() + occlusion_.log() + width_.log(); }

  /// Draws the three maps. The frame block of the light's view and the model's vertex array have to be bound.
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
