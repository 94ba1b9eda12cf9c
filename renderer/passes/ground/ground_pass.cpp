#include "renderer/passes/ground/ground_pass.h"

#include "renderer/passes/draw/draw.h"
#include "renderer/shaders/constants.h"

namespace pelage {

namespace shaders {
extern const char* const ground_vert;
extern const char* const ground_frag;
}  // namespace shaders

namespace {

constexpr int contact_texels = 256;
constexpr float contact_radius = 0.75f;  // of the view from below: the model and what surrounds it, sizes

}  // namespace

GroundPass::GroundPass(const Gl& gl)
    : nothing_(gl), view_block_(gl), contact_(gl, GL_R32F, contact_texels, contact_texels, true) {
  from_below_ = *view_of_light({.direction = {0, 1, 0}}, contact_radius, contact_texels);
  gl.TextureParameteri(contact_.texture(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TextureParameteri(contact_.texture(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

const Program& GroundPass::program_of(const Gl& gl, const std::string& variant) {
  const auto [place, made] = programs_.try_emplace(variant, gl, shaders::ground_vert, shaders::ground_frag, variant);
  if (made) failure_ += place->second.log();
  return place->second;
}

void GroundPass::prepare(const Gl& gl, const FurFrame& frame, const ModelBuffers& model,
                         const ModelBuffers::DrawList& triangles, const SceneShadowPass& depth) {
  if (model_ == frame.model) return;
  model_ = frame.model;
  FrameBlock seen;
  seen.world_to_clip = from_below_.world_to_clip;
  gl.NamedBufferData(view_block_.id(), sizeof(FrameBlock), &seen, GL_STREAM_DRAW);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, frame_binding, view_block_.id());
  gl.BindVertexArray(model.vertex_array());
  depth.draw_depth(gl, triangles, from_below_, contact_);
}

void GroundPass::draw(const Gl& gl, const FurFrame& frame, const std::string& variant) {
  const FurGround& ground = *frame.ground;
  if (frame.camera.position.y <= ground.height) return;
  const Program& program = program_of(gl, variant);
  gl.BindVertexArray(nothing_.id());
  gl.BindTextureUnit(contact_unit, contact_.texture());
  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
  program.use();
  program.set("height", ground.height);
  program.set("from_below", from_below_.world_to_clip);
  program.set("lowest", from_below_.axis.y * ground.height + from_below_.axis.w);
  program.set("shadow_strength", ground.shadow);
  program.set("contact_strength", ground.contact);
  gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace pelage
