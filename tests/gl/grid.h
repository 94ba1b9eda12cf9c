// Evaluates a shader for each pixel of a square, to compare GLSL with C++.
#pragma once

#include <vector>

#include "renderer/gl/handles.h"
#include "renderer/gl/program.h"

namespace pelage::testing {

/// Sends an array texture of side x side texels for each index, one index after the other; to be read with texelFetch,
/// or clamped with linear filtering.
inline Texture send_images(const Gl& gl, int side, const std::vector<glm::vec4>& texels, bool linear = false) {
  Texture texture(gl, GLenum{GL_TEXTURE_2D_ARRAY});
  const int layers = static_cast<int>(texels.size()) / (side * side);
  gl.TextureStorage3D(texture.id(), 1, GL_RGBA32F, side, side, layers);
  gl.TextureSubImage3D(texture.id(), 0, 0, 0, 0, side, side, layers, GL_RGBA, GL_FLOAT, texels.data());
  gl.TextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER, linear ? GL_LINEAR : GL_NEAREST);
  gl.TextureParameteri(texture.id(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TextureParameteri(texture.id(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

/// Sends a uniform block, which is bound at `binding` for as long as the buffer lives.
template <class Block>
Buffer send_block(const Gl& gl, GLuint binding, const Block& block) {
  Buffer buffer(gl);
  gl.NamedBufferData(buffer.id(), sizeof block, &block, GL_STATIC_DRAW);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, binding, buffer.id());
  return buffer;
}

/// Returns what the program in use writes for each pixel.
inline std::vector<glm::vec4> answers(const Gl& gl, int side) {
  const RenderTarget target(gl, GL_RGBA32F, side, side, false);
  const VertexArray nothing(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
  gl.Viewport(0, 0, side, side);
  gl.BindVertexArray(nothing.id());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  std::vector<glm::vec4> pixels(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  gl.ReadPixels(0, 0, side, side, GL_RGBA, GL_FLOAT, pixels.data());
  return pixels;
}

}  // namespace pelage::testing
