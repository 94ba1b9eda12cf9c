#include "renderer/passes/aovs/aov_target.h"

#include <cassert>

namespace pelage {

namespace {

/// Location in renderer/shaders/aovs.glsl; 0 for AOVs that are not written there.
std::size_t place_of(Aov aov) {
  switch (aov) {
    case Aov::beauty:
    case Aov::alpha:
    case Aov::depth: return 0;
    case Aov::position: return 1;
    case Aov::normal: return 2;
    case Aov::tangent: return 3;
    case Aov::albedo: return 4;
    case Aov::direct: return 5;
    case Aov::shadow: return 6;
    case Aov::shell_count: return 7;
  }
  assert(false);
  return 0;
}

}  // namespace

AovTarget::AovTarget(const Gl& gl, std::span<const Aov> aovs, int width, int height)
    : width_(width), height_(height), framebuffer_(gl), depth_(gl) {
  std::array<GLenum, places> buffers{};
  for (const Aov aov : aovs) {
    const std::size_t place = place_of(aov);
    if (place == 0) continue;
    Texture texture(gl, GLenum{GL_TEXTURE_2D});
    gl.TextureStorage2D(texture.id(), 1, GL_RGBA32F, width, height);
    gl.TextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TextureParameteri(texture.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    buffers[place] = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(place);
    gl.NamedFramebufferTexture(framebuffer_.id(), buffers[place], texture.id(), 0);
    textures_[place] = std::move(texture);
  }
  gl.NamedRenderbufferStorage(depth_.id(), GL_DEPTH_COMPONENT32F, width, height);
  gl.NamedFramebufferRenderbuffer(framebuffer_.id(), GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
  gl.NamedFramebufferDrawBuffers(framebuffer_.id(), static_cast<GLsizei>(places), buffers.data());
  complete_ = gl.GetError() == GL_NO_ERROR &&
              gl.CheckNamedFramebufferStatus(framebuffer_.id(), GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

GLuint AovTarget::texture(Aov aov) const {
  assert(textures_[place_of(aov)]);
  return textures_[place_of(aov)].id();
}

bool AovTarget::holds(Aov aov) { return place_of(aov) != 0; }

void AovTarget::clear(const Gl& gl) const {
  const std::array<float, 4> nothing{};
  for (std::size_t place = 0; place < places; ++place) {
    if (textures_[place])
      gl.ClearNamedFramebufferfv(framebuffer_.id(), GL_COLOR, static_cast<GLint>(place), nothing.data());
  }
  const float far_away = 0;
  gl.ClearNamedFramebufferfv(framebuffer_.id(), GL_DEPTH, 0, &far_away);
}

}  // namespace pelage
