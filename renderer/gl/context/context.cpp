#include "renderer/gl/context/context.h"

#include <fmt/format.h>

#include <array>

#include "renderer/gl/render_target.h"

namespace pelage {

namespace {

std::string text(const Gl& gl, GLenum name) {
  const GLubyte* value = gl.GetString(name);
  return value ? reinterpret_cast<const char*>(value) : "?";
}

bool draws_a_pixel(const Gl& gl) {
  const RenderTarget target(gl, GL_RGBA8, 1, 1, false);
  if (!target.complete()) return false;
  const std::array<float, 4> colour{0.2f, 0.4f, 0.6f, 1.0f};
  gl.ClearNamedFramebufferfv(target.framebuffer(), GL_COLOR, 0, colour.data());
  std::array<GLubyte, 4> pixel{};
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, target.framebuffer());
  gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  return pixel == std::array<GLubyte, 4>{51, 102, 153, 255};
}

}  // namespace

Status Context::prove(const std::string& name, const LoadFunction& find) {
  const std::string missing = gl_.load(find);
  if (!missing.empty()) return failure(Code::unavailable, fmt::format("{}: no {}", name, missing));
  const std::string renderer = text(gl_, GL_RENDERER);
  description_ = fmt::format("{}, {}, OpenGL {}", name, renderer, text(gl_, GL_VERSION));
  software_ = renderer.find("llvmpipe") != std::string::npos || renderer.find("softpipe") != std::string::npos;
  if (!draws_a_pixel(gl_)) return failure(Code::unavailable, description_ + ": a test pixel came out wrong");
  return {};
}

}  // namespace pelage
