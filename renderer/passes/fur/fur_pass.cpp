#include "renderer/passes/fur/fur_pass.h"

#include <array>

namespace pelage {

namespace shaders {
extern const char* const fur_vert;
extern const char* const fur_frag;
extern const char* const solid_frag;
extern const char* const skin_vert;
extern const char* const skin_frag;
}  // namespace shaders

namespace {

// Fur behind dense fur of something nearer is hidden by a coarse depth of it, written a fur length further away so that
// the layers of one coat do not hide each other. Without it the body's outer layers would cover an ear's fringe.
constexpr int solid_shells = 4;
constexpr float solid_push = 1.0f;

const void* first_index(GLsizei index) {
  return reinterpret_cast<const void*>(static_cast<std::uintptr_t>(index) * sizeof(GLuint));
}

void clear(const Gl& gl, const RenderTarget& target) {
  const std::array<float, 4> nothing{};
  const float far_away = 0;
  gl.ClearNamedFramebufferfv(target.framebuffer(), GL_COLOR, 0, nothing.data());
  gl.ClearNamedFramebufferfv(target.framebuffer(), GL_DEPTH, 0, &far_away);
}

void set_state(const Gl& gl, const RenderTarget& target) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
  gl.Viewport(0, 0, target.width(), target.height());
  gl.ClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);  // rows from the top, depth as reversed floats want it
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_GEQUAL);
  gl.Disable(GL_CULL_FACE);
}

}  // namespace

FurPass::FurPass(const Gl& gl)
    : skin_(gl, shaders::skin_vert, shaders::skin_frag), solid_(gl, shaders::fur_vert, shaders::solid_frag),
      fur_(gl, shaders::fur_vert, shaders::fur_frag), block_(gl) {
  gl.NamedBufferData(block_.id(), sizeof(FrameBlock), nullptr, GL_STREAM_DRAW);
}

void FurPass::draw(const Gl& gl, const FrameBlock& block, ModelBuffers& model, const CoatTextures& coat,
                   const RenderTarget& target) {
  clear(gl, target);
  set_state(gl, target);
  const auto lists = model.sort_for(gl, glm::vec3(block.eye));
  gl.NamedBufferSubData(block_.id(), 0, sizeof(FrameBlock), &block);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, 0, block_.id());
  gl.BindVertexArray(model.vertex_array());
  gl.BindTextureUnit(0, coat.shapes());
  gl.BindTextureUnit(1, coat.colours());
  gl.BindTextureUnit(2, model.base_images());

  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
  skin_.use();
  gl.DrawElements(GL_TRIANGLES, lists.all, GL_UNSIGNED_INT, first_index(0));
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  draw_shells(gl, solid_, lists, solid_shells, solid_push);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);

  gl.DepthMask(GL_FALSE);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  draw_shells(gl, fur_, lists, static_cast<int>(block.counts.x), 0);
  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
}

void FurPass::draw_shells(const Gl& gl, const Program& program, const ModelBuffers::DrawLists& lists, int shells,
                          float push) const {
  program.use();
  program.set("shell_count", shells);
  program.set("push", push);
  program.set("first_shell", shells - 1);
  program.set("shell_step", -1);
  gl.DrawElementsInstanced(GL_TRIANGLES, lists.averted, GL_UNSIGNED_INT, first_index(lists.all + lists.facing), shells);
  program.set("first_shell", 0);
  program.set("shell_step", 1);
  gl.DrawElementsInstanced(GL_TRIANGLES, lists.facing, GL_UNSIGNED_INT, first_index(lists.all), shells);
}

}  // namespace pelage
