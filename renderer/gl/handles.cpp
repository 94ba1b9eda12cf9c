#include "renderer/gl/handles.h"

namespace pelage {

RenderTarget::RenderTarget(const Gl& gl, GLenum colour, int width, int height, bool depth)
    : colour_(colour), width_(width), height_(height), framebuffer_(gl), texture_(gl, GLenum{GL_TEXTURE_2D}) {
  gl.TextureStorage2D(texture_.id(), 1, colour, width, height);
  gl.TextureParameteri(texture_.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TextureParameteri(texture_.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.NamedFramebufferTexture(framebuffer_.id(), GL_COLOR_ATTACHMENT0, texture_.id(), 0);
  if (depth) {
    depth_buffer_ = Renderbuffer(gl);
    gl.NamedRenderbufferStorage(depth_buffer_.id(), GL_DEPTH_COMPONENT32F, width, height);
    gl.NamedFramebufferRenderbuffer(framebuffer_.id(), GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_buffer_.id());
  }
  complete_ = gl.GetError() == GL_NO_ERROR &&
              gl.CheckNamedFramebufferStatus(framebuffer_.id(), GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

}  // namespace pelage
