#include "renderer/shells/shell_shadow/shell_shadow_pass.h"

#include <array>

#include "renderer/shells/draw/draw.h"

namespace pelage {

namespace shaders {
extern const char* const fur_vert;
extern const char* const skin_vert;
extern const char* const skin_frag;
extern const char* const shell_shadow_frag;
}  // namespace shaders

namespace {

void keep(const Gl& gl, const RenderTarget& target, GLuint maps, int slice) {
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, target.framebuffer());
  gl.CopyTextureSubImage3D(maps, 0, 0, 0, slice, 0, 0, target.width(), target.height());
}

}  // namespace

ShellShadowPass::ShellShadowPass(const Gl& gl)
    : skin_(gl, shaders::skin_vert, shaders::skin_frag), failure_(skin_.log()) {}

const Program& ShellShadowPass::program_of(const Gl& gl, const std::string& variant) {
  const auto [entry, made] = programs_.try_emplace(variant, gl, shaders::fur_vert, shaders::shell_shadow_frag, variant);
  if (made) failure_ += entry->second.log();
  return entry->second;
}

void ShellShadowPass::draw(const Gl& gl, const std::string& variant, const ModelBuffers::DrawList& triangles,
                           const RenderTarget& target, GLuint maps, int first_slice) {
  const std::array<float, 4> all{1, 1, 1, 1};
  set_draw_state(gl, target);
  clear_target(gl, target, all);
  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  skin_.use();
  draw_list(gl, triangles);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.DepthMask(GL_FALSE);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ZERO, GL_SRC_COLOR);
  const Program& program = program_of(gl, variant);
  program.use();
  program.set("push", 0.0f);
  program.set("shell_count", shadow_shells);
  program.set("shell_side", 1);
  for (int shell = shadow_shells - 1; shell >= 0; --shell) {
    keep(gl, target, maps, first_slice + shell + 1);
    program.set("shell", shell);
    draw_list(gl, triangles);
  }
  keep(gl, target, maps, first_slice);
  gl.Disable(GL_BLEND);
  gl.DepthMask(GL_TRUE);
}

}  // namespace pelage
