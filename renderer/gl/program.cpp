#include "renderer/gl/program.h"

#include <array>
#include <string_view>

namespace pelage {

namespace {

GLuint compile(const Gl& gl, GLenum stage, std::string_view source, const std::string& defines, std::string& log) {
  const GLuint shader = gl.CreateShader(stage);
  const std::size_t line = source.find('\n') + 1;  // after the #version line, which comes first
  const std::string full_source = std::string(source.substr(0, line)) + defines + std::string(source.substr(line));
  const char* lines = full_source.c_str();
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

Program::Program(const Gl& gl, const char* vertex, const char* fragment, const std::string& defines) : Program(gl) {
  add(GL_VERTEX_SHADER, vertex, defines), add(GL_FRAGMENT_SHADER, fragment, defines);
  link();
}

Program Program::of_compute(const Gl& gl, const char* source, const std::string& defines) {
  Program program(gl);
  program.add(GL_COMPUTE_SHADER, source, defines);
  program.link();
  return program;
}

void Program::add(GLenum stage, const char* source, const std::string& defines) {
  const GLuint shader = compile(*gl_, stage, source, defines, log_);
  gl_->AttachShader(handle_.id(), shader);
  gl_->DeleteShader(shader);  // lives on while attached
}

void Program::link() {
  gl_->LinkProgram(handle_.id());
  GLint linked = 0;
  gl_->GetProgramiv(handle_.id(), GL_LINK_STATUS, &linked);
  if (linked) return;
  std::array<char, 2048> text{};
  gl_->GetProgramInfoLog(handle_.id(), text.size(), nullptr, text.data());
  log_ += text.data();
  handle_ = {};
}

}  // namespace pelage
