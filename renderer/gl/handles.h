// Move-only owners of GL objects; their id is 0 when moved from. They must be destroyed before the context, on its
// thread.
#pragma once

#include <utility>

#include "renderer/gl/functions.h"

namespace pelage {

/// Owns one object. `Kind` creates and destroys it.
template <class Kind>
class Handle {
 public:
  Handle() = default;
  template <class... Arguments>
  explicit Handle(const Gl& gl, Arguments... arguments) : gl_(&gl), id_(Kind::create(gl, arguments...)) {
    gl.count_object();
  }
  Handle(Handle&& other) noexcept : gl_(other.gl_), id_(std::exchange(other.id_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(id_, other.id_);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (id_) Kind::destroy(*gl_, id_);
  }

  GLuint id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }

 private:
  const Gl* gl_ = nullptr;
  GLuint id_ = 0;
};

struct BufferKind {
  static GLuint create(const Gl& gl) {
    GLuint id = 0;
    gl.CreateBuffers(1, &id);
    return id;
  }
  static void destroy(const Gl& gl, GLuint id) { gl.DeleteBuffers(1, &id); }
};
struct TextureKind {
  static GLuint create(const Gl& gl, GLenum target) {
    GLuint id = 0;
    gl.CreateTextures(target, 1, &id);
    return id;
  }
  static void destroy(const Gl& gl, GLuint id) { gl.DeleteTextures(1, &id); }
};
struct VertexArrayKind {
  static GLuint create(const Gl& gl) {
    GLuint id = 0;
    gl.CreateVertexArrays(1, &id);
    return id;
  }
  static void destroy(const Gl& gl, GLuint id) { gl.DeleteVertexArrays(1, &id); }
};
struct FramebufferKind {
  static GLuint create(const Gl& gl) {
    GLuint id = 0;
    gl.CreateFramebuffers(1, &id);
    return id;
  }
  static void destroy(const Gl& gl, GLuint id) { gl.DeleteFramebuffers(1, &id); }
};
struct RenderbufferKind {
  static GLuint create(const Gl& gl) {
    GLuint id = 0;
    gl.CreateRenderbuffers(1, &id);
    return id;
  }
  static void destroy(const Gl& gl, GLuint id) { gl.DeleteRenderbuffers(1, &id); }
};
struct QueryKind {
  static GLuint create(const Gl& gl, GLenum target) {
    GLuint id = 0;
    gl.CreateQueries(target, 1, &id);
    return id;
  }
  static void destroy(const Gl& gl, GLuint id) { gl.DeleteQueries(1, &id); }
};
struct ProgramKind {
  static GLuint create(const Gl& gl) { return gl.CreateProgram(); }
  static void destroy(const Gl& gl, GLuint id) { gl.DeleteProgram(id); }
};

using Buffer = Handle<BufferKind>;
using Texture = Handle<TextureKind>;
using QueryObject = Handle<QueryKind>;
using VertexArray = Handle<VertexArrayKind>;
using Framebuffer = Handle<FramebufferKind>;
using Renderbuffer = Handle<RenderbufferKind>;

/// A framebuffer with a colour texture and, if asked for, a 32-bit float depth buffer.
class RenderTarget {
 public:
  RenderTarget() = default;
  RenderTarget(const Gl& gl, GLenum colour, int width, int height, bool depth);

  bool has_depth() const { return static_cast<bool>(depth_buffer_); }
  /// Returns whether the GL had memory for it and can draw to it.
  bool complete() const { return complete_; }
  bool matches(GLenum colour, int width, int height) const {
    return complete_ && colour == colour_ && width == width_ && height == height_;
  }
  GLuint framebuffer() const { return framebuffer_.id(); }
  GLuint texture() const { return texture_.id(); }
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  GLenum colour_ = 0;
  int width_ = 0, height_ = 0;
  bool complete_ = false;
  Framebuffer framebuffer_;
  Texture texture_;
  Renderbuffer depth_buffer_;
};

}  // namespace pelage
