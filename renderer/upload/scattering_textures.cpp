#include "renderer/upload/scattering_textures.h"

#include "renderer/coat/strand_tile.h"
#include "renderer/shaders/constants.h"
#include "renderer/shading/scattering_table.h"

namespace pelage {

namespace {

Texture send_table(const Gl& gl, const ScatteringTable& table) {
  Texture texture(gl, GLenum{GL_TEXTURE_3D});
  gl.TextureStorage3D(texture.id(), 1, GL_RGBA32F, table.azimuths, table.inclinations, table.absorptions);
  gl.TextureSubImage3D(texture.id(), 0, 0, 0, 0, table.azimuths, table.inclinations, table.absorptions, GL_RGBA,
                       GL_FLOAT, table.values.data());
  for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TextureParameteri(texture.id(), name, GL_LINEAR);
  for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
    gl.TextureParameteri(texture.id(), name, GL_CLAMP_TO_EDGE);
  }
  return texture;
}

}  // namespace

void ScatteringTextures::prepare(const Gl& gl, const FurFrame& frame) {
  const Look look = wet_look(frame.coat, frame.look);
  if (look_ != look) {
    look_ = look;
    const ScatteringBlock block = scattering_block(look);
    gl.NamedBufferData(block_.id(), sizeof block, &block, GL_STATIC_DRAW);
    const ScatteringTable table = make_scattering_table(look);
    table_ = table.empty() ? Texture() : send_table(gl, table);
  }
  gl.BindBufferBase(GL_UNIFORM_BUFFER, scattering_binding, block_.id());
  if (table_) gl.BindTextureUnit(scattering_unit, table_.id());
}

}  // namespace pelage
