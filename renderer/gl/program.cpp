#include "renderer/gl/program.h"

#include <array>

namespace pelage {

namespace {

GLuint compile(const Gl& gl, GLenum stage, const char* source, std::string& log) {
  const GLuint shader = gl.CreateShader(stage);
  gl.ShaderSource(shader, 1, &source, nullptr);
  gl.CompileShader(shader);
  GLint compiled = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (!compiled) {
    std::array<char, 2048> text{};
    gl.GetShaderInfoLog(shader, text.size(), nullptr, text.data());
    log += text.data();
  }
  return shader;
}

}  // namespace

Program::Program(const Gl& gl, const char* vertex, const char* fragment) : gl_(&gl), handle_(gl) {
  for (const auto& [stage, source] : {std::pair{GLenum{GL_VERTEX_SHADER}, vertex}, {GLenum{GL_FRAGMENT_SHADER}, fragment}}) {
    const GLuint shader = compile(gl, stage, source, log_);
    gl.AttachShader(handle_.id(), shader);
    gl.DeleteShader(shader);  // lives on while attached
  }
  gl.LinkProgram(handle_.id());
  GLint linked = 0;
  gl.GetProgramiv(handle_.id(), GL_LINK_STATUS, &linked);
  if (linked) return;
  std::array<char, 2048> text{};
  gl.GetProgramInfoLog(handle_.id(), text.size(), nullptr, text.data());
  log_ += text.data();
  handle_ = {};
}

}  // namespace pelage
