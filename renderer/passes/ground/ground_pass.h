// A level ground that catches the shadow of the lights and darkens where the model is near.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "renderer/gl/handles.h"
#include "renderer/gl/program.h"
#include "renderer/input/fur_scene.h"
#include "renderer/passes/scene_shadow/scene_shadow_pass.h"
#include "renderer/upload/blocks.h"
#include "renderer/upload/model_buffers.h"

namespace pelage {

class GroundPass {
 public:
  explicit GroundPass(const Gl& gl);

  std::string failure() const { return failure_; }

  /// Draws the model as it is seen from below, once for each model. Changes the bound target.
  void prepare(const Gl& gl, const FurFrame& frame, const ModelBuffers& model, const ModelBuffers::DrawList& triangles,
               const SceneShadowPass& depth);  // binds a block of its own

  /// Into the bound target: premultiplied black, and depth. The frame's block is bound, and its shadow maps where the
  /// variant has SHADOW_MAPS. Draws nothing for an eye below the ground.
  void draw(const Gl& gl, const FurFrame& frame, const std::string& variant);

 private:
  const Program& program_of(const Gl& gl, const std::string& variant);

  std::map<std::string, Program> programs_;  // by variant, made when first used
  std::string failure_;
  VertexArray nothing_;
  Buffer view_block_;
  RenderTarget contact_;
  LightView from_below_;
  std::uint64_t model_ = 0;
};

}  // namespace pelage
