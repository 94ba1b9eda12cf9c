// Where shaders with LAYERS write what a frame keeps beside colour.
#pragma once

#include <array>
#include <span>

#include "protocol/commands/frame.h"
#include "renderer/gl/handles.h"

namespace pelage {

/// RGBA32F textures for the layers that are asked for, and none for the others, with one depth buffer.
class LayerTarget {
 public:
  /// Beauty, alpha and depth have no texture here.
  LayerTarget(const Gl& gl, std::span<const FrameLayer> layers, int width, int height);

  bool complete() const { return complete_; }
  GLuint framebuffer() const { return framebuffer_.id(); }
  int width() const { return width_; }
  int height() const { return height_; }
  /// Of a layer that was asked for.
  GLuint texture(FrameLayer layer) const;
  /// Whether a layer has a texture here at all.
  static bool holds(FrameLayer layer);
  void clear(const Gl& gl) const;

 private:
  static constexpr std::size_t places = 8;  // colour is the first; see renderer/shaders/layers.glsl

  int width_, height_;
  bool complete_ = false;
  Framebuffer framebuffer_;
  std::array<Texture, places> textures_;
  Renderbuffer depth_;
};

}  // namespace pelage
