#pragma once

#include "renderer/gl/handles.h"

namespace pelage {

/// A colour texture, with a 32-bit float depth buffer where asked for.
class RenderTarget {
 public:
  RenderTarget() = default;
  RenderTarget(const Gl& gl, GLenum colour, int width, int height, bool depth);

  bool has_depth() const { return static_cast<bool>(depth_buffer_); }
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
