#include "renderer/gl/program.h"

#include <array>
#include <string_view>
#include <utility>

namespace pelage {

namespace {

GLuint compile(const Gl& gl, GLenum stage, std::string_view source, const std::string& defines, std::string& log) {
  const GLuint shader = gl.CreateShader(stage);
  const std::size_t line = source.find('\n') + 1;  // the version comes first
  const std::string whole = std::string(source.substr(0, line)) + defines + std::string(source.substr(line));
  const char* lines = whole.c_str();
  gl.ShaderSource(shader, 1, &lines, nullptr);
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

Program::Program(const Gl& gl, const char* vertex, const char* fragment, const std::string& defines)
    : gl_(&gl), handle_(gl) {
  for (const auto& [stage, source] :
       {std::pair{GLenum{GL_VERTEX_SHADER}, vertex}, {GLenum{GL_FRAGMENT_SHADER}, fragment}}) {
    const GLuint shader = compile(gl, stage, source, defines, log_);
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
