// A linked OpenGL shader program.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "renderer/gl/handles.h"

namespace pelage {

/// A linked vertex and fragment shader, or a compute shader. The build has checked the sources, so a failure here means
/// a broken driver; the program is then empty (id 0) and log() says why.
class Program {
 public:
  Program() = default;
  /// `defines`: lines such as "#define SHADOW_MAPS\n", which are inserted after the #version line of both sources.
  Program(const Gl& gl, const char* vertex, const char* fragment, const std::string& defines = {});
  static Program of_compute(const Gl& gl, const char* source, const std::string& defines = {});

  void use() const { gl_->UseProgram(handle_.id()); }
  void set(const char* name, int value) const { gl_->Uniform1i(location(name), value); }
  void set(const char* name, unsigned value) const { gl_->Uniform1ui(location(name), value); }
  void set(const char* name, glm::ivec2 value) const { gl_->Uniform2i(location(name), value.x, value.y); }
  void set(const char* name, glm::vec3 value) const { gl_->Uniform3f(location(name), value.x, value.y, value.z); }
  void set(const char* name, float value) const { gl_->Uniform1f(location(name), value); }
  void set(const char* name, const glm::mat4& value) const {
    gl_->UniformMatrix4fv(location(name), 1, GL_FALSE, &value[0][0]);
  }
  GLuint id() const { return handle_.id(); }
  const std::string& log() const { return log_; }

 private:
  explicit Program(const Gl& gl) : gl_(&gl), handle_(gl) {}
  void add(GLenum stage, const char* source, const std::string& defines);
  void link();
  GLint location(const char* name) const { return gl_->GetUniformLocation(handle_.id(), name); }

  const Gl* gl_ = nullptr;
  Handle<ProgramKind> handle_;
  std::string log_;
};

}  // namespace pelage
