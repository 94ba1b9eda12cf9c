#include "renderer/upload/coat_textures.h"

namespace pelage {

namespace {

using Texels = std::vector<std::uint8_t> SliceLevel::*;

Texture send(const Gl& gl, const Slices& slices, Texels texels, GLenum magnified, UploadCount& count) {
  Texture texture(gl, GLenum{GL_TEXTURE_2D_ARRAY});
  gl.TextureStorage3D(texture.id(), slice_levels, GL_RGBA8, slice_texels, slice_texels, slice_count);
  for (int i = 0; i < slice_levels; ++i) {
    const SliceLevel& level = slices.levels[static_cast<std::size_t>(i)];
    gl.TextureSubImage3D(texture.id(), i, 0, 0, 0, level.texels, level.texels, slice_count, GL_RGBA, GL_UNSIGNED_BYTE,
                         (level.*texels).data());
    count.bytes += (level.*texels).size();
  }
  gl.TextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  gl.TextureParameteri(texture.id(), GL_TEXTURE_MAG_FILTER, static_cast<GLint>(magnified));
  gl.TextureParameteri(texture.id(), GL_TEXTURE_WRAP_S, GL_REPEAT);
  gl.TextureParameteri(texture.id(), GL_TEXTURE_WRAP_T, GL_REPEAT);
  count.buffers += 1;
  return texture;
}

}  // namespace

CoatTextures::CoatTextures(const Gl& gl, const Coat& coat, UploadCount& count)
    : coat_(coat), slices_(bake_slices(coat)) {
  shapes_ = send(gl, slices_, &SliceLevel::shape, GL_LINEAR, count);
  colours_ = send(gl, slices_, &SliceLevel::colour, GL_LINEAR, count);
  for (SliceLevel& level : slices_.levels) level.shape = {}, level.colour = {};  // the GPU has them now
}

}  // namespace pelage
