#include "renderer/upload/volume_texture.h"

namespace pelage {

Texture volume_texture(const Gl& gl, const SurfaceVolume& volume) {
  Texture texture(gl, GLenum{GL_TEXTURE_3D});
  gl.TextureStorage3D(texture.id(), 1, GL_RGBA8, volume.size.x, volume.size.y, volume.size.z);
  gl.TextureSubImage3D(texture.id(), 0, 0, 0, 0, volume.size.x, volume.size.y, volume.size.z, GL_RGBA, GL_UNSIGNED_BYTE,
                       volume.rgba.data());
  for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TextureParameteri(texture.id(), name, GL_LINEAR);
  for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    gl.TextureParameteri(texture.id(), name, GL_CLAMP_TO_EDGE);
  return texture;
}

}  // namespace pelage
