#include "renderer/passes/resolve/resolve_pass.h"

#include <cmath>

namespace pelage {

namespace shaders {
extern const char* const whole_target_vert;
extern const char* const resolve_frag;
}  // namespace shaders

ResolvePass::ResolvePass(const Gl& gl) : program_(gl, shaders::whole_target_vert, shaders::resolve_frag), nothing_(gl) {}

void ResolvePass::draw(const Gl& gl, const FurFrame& frame, const RenderTarget& drawn, const RenderTarget& picture) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, picture.framebuffer());
  gl.Viewport(0, 0, picture.width(), picture.height());
  gl.Disable(GL_DEPTH_TEST);
  program_.use();
  program_.set("exposure", static_cast<float>(std::exp2(frame.exposure)));
  program_.set("filmic", frame.tone_map == ToneMap::filmic ? 1 : 0);
  program_.set("transparent", frame.background == Background::transparent ? 1 : 0);
  program_.set("background_r", frame.background_colour.r);
  program_.set("background_g", frame.background_colour.g);
  program_.set("background_b", frame.background_colour.b);
  program_.set("scale", static_cast<float>(drawn.height()) / static_cast<float>(picture.height()));
  gl.BindTextureUnit(0, drawn.texture());
  gl.BindVertexArray(nothing_.id());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace pelage
