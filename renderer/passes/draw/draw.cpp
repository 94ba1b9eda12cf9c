#include "renderer/passes/draw/draw.h"

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
  const float far_away = 0;
  if (target.has_depth()) gl.ClearNamedFramebufferfv(target.framebuffer(), GL_DEPTH, 0, &far_away);
}

void draw_list(const Gl& gl, const ModelBuffers::DrawList& list) {
  const auto offset = static_cast<std::uintptr_t>(list.first) * sizeof(GLuint);
  gl.DrawElements(GL_TRIANGLES, list.count, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset));
}

namespace {

constexpr float opaque = 0.9f, visible = 0.004f;  // opacities

}  // namespace

void draw_strips(const Gl& gl, int segments, std::size_t count) {
  if (count == 0) return;
  gl.DrawElementsInstanced(GL_TRIANGLE_STRIP, 2 * (segments + 1), GL_UNSIGNED_INT, nullptr,
                           static_cast<GLsizei>(count));
}

void draw_all_strips(const Gl& gl, const Program& program, int segments, std::size_t count) {
  program.use();
  program.set("segments", segments);
  program.set("first", 0);
  program.set("min_opacity", visible);
  draw_strips(gl, segments, count);
}

void draw_four_passes(const Gl& gl, const Program& program, int segments, std::size_t back_facing, std::size_t count) {
  const auto draw = [&](std::size_t first, std::size_t number, float min_opacity) {
    program.set("first", static_cast<int>(first));
    program.set("min_opacity", min_opacity);
    draw_strips(gl, segments, number);
  };
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl.Disable(GL_BLEND);
  gl.DepthMask(GL_TRUE);
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  draw(0, count, opaque);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.DepthMask(GL_FALSE);
  gl.DepthFunc(GL_EQUAL);
  gl.Enable(GL_BLEND);
  draw(0, count, opaque);
  gl.DepthFunc(GL_GREATER);
  draw(0, back_facing, visible);
  gl.DepthMask(GL_TRUE);
  draw(back_facing, count - back_facing, visible);
  gl.DepthFunc(GL_GEQUAL);
  gl.Disable(GL_BLEND);
}

void draw_unordered(const Gl& gl, const Program& program, int segments, std::size_t count) {
  gl.DepthMask(GL_FALSE);
  draw_all_strips(gl, program, segments, count);
  gl.DepthMask(GL_TRUE);
}

}  // namespace pelage
