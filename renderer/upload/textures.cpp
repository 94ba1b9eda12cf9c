#include "renderer/upload/textures.h"

#include <utility>

#include "renderer/coat/strand_tile.h"
#include "renderer/shaders/constants.h"

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

CoatTextures::CoatTextures(const Gl& gl, const Coat& coat, Slices slices, UploadCount& count)
    : coat_(coat), slices_(std::move(slices)) {
  shapes_ = send(gl, slices_, &SliceLevel::shape, GL_LINEAR, count);
  colours_ = send(gl, slices_, &SliceLevel::colour, GL_LINEAR, count);
  for (SliceLevel& level : slices_.levels) level.shape = {}, level.colour = {};  // the GPU has them now
}

namespace {

Texture send(const Gl& gl, const ClumpMap& map) {
  Texture texture(gl, GLenum{GL_TEXTURE_2D});
  gl.TextureStorage2D(texture.id(), 1, GL_RGBA8, ClumpMap::side, ClumpMap::side);
  gl.TextureSubImage2D(texture.id(), 0, 0, 0, ClumpMap::side, ClumpMap::side, GL_RGBA, GL_UNSIGNED_BYTE,
                       map.texels.data());
  for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TextureParameteri(texture.id(), name, GL_LINEAR);
  for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) gl.TextureParameteri(texture.id(), name, GL_REPEAT);
  return texture;
}

}  // namespace

void PaintTextures::prepare(const Gl& gl, const Coat& coat) {
  if (!coat_ || !same_strands(*coat_, coat)) {
    const ClumpMap map = bake_clump_map(coat);
    clumps_ = send(gl, map);
    const glm::vec4 block(coat.wetness, coat.curl, coat.curl_turns, map.reach);
    gl.NamedBufferData(uniforms_.id(), sizeof block, &block, GL_STATIC_DRAW);
    coat_ = coat;
  }
  gl.BindBufferBase(GL_UNIFORM_BUFFER, paint_binding, uniforms_.id());
  gl.BindTextureUnit(clump_unit, clumps_.id());
}

}  // namespace pelage
