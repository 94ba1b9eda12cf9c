#include "renderer/passes/draw/draw_state.h"

#include <cstdint>

namespace pelage {

void set_draw_state(const Gl& gl, const RenderTarget& target) {
  set_draw_state(gl, target.framebuffer(), target.width(), target.height());
}

void set_draw_state(const Gl& gl, GLuint framebuffer, int width, int height) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.Viewport(0, 0, width, height);
  gl.ClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);  // rows from the top, depth as reversed floats want it
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_GEQUAL);
  gl.Disable(GL_CULL_FACE);
}

void clear_target(const Gl& gl, const RenderTarget& target, const std::array<float, 4>& colour) {
  gl.ClearNamedFramebufferfv(target.framebuffer(), GL_COLOR, 0, colour.data());
  if (target.has_depth()) gl.ClearNamedFramebufferfi(target.framebuffer(), GL_DEPTH_STENCIL, 0, 0, 0);
}

void draw_list(const Gl& gl, const ModelBuffers::DrawList& list) {
  const auto offset = static_cast<std::uintptr_t>(list.first) * sizeof(GLuint);
  gl.DrawElements(GL_TRIANGLES, list.count, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset));
}

}  // namespace pelage
