#include "renderer/passes/resolve/resolve_pass.h"

#include <cmath>

#include "renderer/shaders/constants.h"

namespace pelage {

namespace shaders {
extern const char* const whole_target_vert;
extern const char* const resolve_frag;
}  // namespace shaders

ResolvePass::ResolvePass(const Gl& gl) : nothing_(gl) { program_of(gl, {}); }

const Program& ResolvePass::program_of(const Gl& gl, const FurFrame& frame) {
  const std::string variant = std::string(frame.background == Background::studio ? "#define STUDIO\n" : "") +
                              (frame.overlay == Overlay::none ? "" : "#define OVERLAY\n");
  const auto [place, made] =
      programs_.try_emplace(variant, gl, shaders::whole_target_vert, shaders::resolve_frag, variant);
  if (made) failure_ += place->second.log();
  return place->second;
}

void ResolvePass::draw(const Gl& gl, const FurFrame& frame, const RenderTarget& drawn, const RenderTarget& picture,
                       int largest, GLuint overlay) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, picture.framebuffer());
  gl.Viewport(0, 0, picture.width(), picture.height());
  gl.Disable(GL_DEPTH_TEST);
  const Program& program = program_of(gl, frame);
  program.use();
  program.set("exposure", static_cast<float>(std::exp2(frame.exposure)));
  program.set("filmic", frame.tone_map == ToneMap::filmic ? 1 : 0);
  program.set("transparent", frame.background == Background::transparent ? 1 : 0);
  program.set("background_r", frame.background_colour.r);
  program.set("background_g", frame.background_colour.g);
  program.set("background_b", frame.background_colour.b);
  program.set("scale", static_cast<float>(drawn.height()) / static_cast<float>(picture.height()));
  if (frame.background == Background::studio)
    program.set("picture_size", glm::vec3(picture.width(), picture.height(), largest));
  gl.BindTextureUnit(source_unit, drawn.texture());
  if (frame.overlay != Overlay::none) gl.BindTextureUnit(overlay_unit, overlay);
  gl.BindVertexArray(nothing_.id());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace pelage
