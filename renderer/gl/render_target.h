#pragma once

#include "renderer/gl/handles.h"

namespace pelage {

/// A colour texture or multisampled colour buffer, with a 32-bit float depth buffer where asked for.
class RenderTarget {
 public:
  RenderTarget() = default;
  /// `colour` is GL_RGBA16F, GL_RGBA32F or GL_RGBA8; samples 1 makes a texture that can be read.
  RenderTarget(const Gl& gl, GLenum colour, int width, int height, int samples, bool depth);

  bool has_depth() const { return static_cast<bool>(depth_buffer_); }
  bool complete() const { return complete_; }
  bool matches(GLenum colour, int width, int height, int samples) const {
    return complete_ && colour == colour_ && width == width_ && height == height_ && samples == samples_;
  }
  GLuint framebuffer() const { return framebuffer_.id(); }
  GLuint texture() const { return texture_.id(); }
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  GLenum colour_ = 0;
  int width_ = 0, height_ = 0, samples_ = 0;
  bool complete_ = false;
  Framebuffer framebuffer_;
  Texture texture_;
  Renderbuffer colour_buffer_, depth_buffer_;
};

}  // namespace pelage
