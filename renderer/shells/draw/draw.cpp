#include "renderer/shells/draw/draw.h"

#include <cstdint>

namespace pelage {

void set_draw_state(const Gl& gl, const RenderTarget& target) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
  gl.Viewport(0, 0, target.width(), target.height());
  gl.ClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);  // rows from the top; depth in [0, 1], as reversed depth needs
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_GEQUAL);
  gl.Disable(GL_CULL_FACE);
}

void clear_target(const Gl& gl, const RenderTarget& target, const std::array<float, 4>& colour) {
  gl.ClearNamedFramebufferfv(target.framebuffer(), GL_COLOR, 0, colour.data());
  const float far_away = 0;
  if (target.has_depth()) gl.ClearNamedFramebufferfv(target.framebuffer(), GL_DEPTH, 0, &far_away);
}

void draw_list(const Gl& gl, const ModelBuffers::DrawList& list) {
  const auto offset = static_cast<std::uintptr_t>(list.first) * sizeof(GLuint);
  gl.DrawElements(GL_TRIANGLES, list.count, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset));
}

}  // namespace pelage
