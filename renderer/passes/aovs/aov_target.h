// Where shaders with AOVS write what a frame keeps beside colour.
#pragma once

#include <array>
#include <span>

#include "protocol/commands/frame.h"
#include "renderer/gl/handles.h"

namespace pelage {

/// RGBA32F textures for the AOVs that are asked for, and none for the others, with one depth buffer.
class AovTarget {
 public:
  /// Beauty, alpha and depth have no texture here.
  AovTarget(const Gl& gl, std::span<const Aov> aovs, int width, int height);

  bool complete() const { return complete_; }
  GLuint framebuffer() const { return framebuffer_.id(); }
  int width() const { return width_; }
  int height() const { return height_; }
  /// Of an AOV that was asked for.
  GLuint texture(Aov aov) const;
  /// Whether an AOV has a texture here at all.
  static bool holds(Aov aov);
  void clear(const Gl& gl) const;

 private:
  static constexpr std::size_t places = 8;  // colour is the first; see renderer/shaders/aovs.glsl

  int width_, height_;
  bool complete_ = false;
  Framebuffer framebuffer_;
  std::array<Texture, places> textures_;
  Renderbuffer depth_;
};

}  // namespace pelage
