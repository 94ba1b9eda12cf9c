#include "renderer/upload/paint_textures.h"

#include "renderer/coat/strand_tile.h"

namespace pelage {

namespace {

constexpr GLuint uniform_binding = 6, texture_unit = 15;  // as in paint.glsl and paint_form.glsl

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
  gl.BindBufferBase(GL_UNIFORM_BUFFER, uniform_binding, uniforms_.id());
  gl.BindTextureUnit(texture_unit, clumps_.id());
}

}  // namespace pelage
