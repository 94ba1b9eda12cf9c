#include "renderer/upload/textures.h"

#include <utility>
#include <vector>

#include "renderer/coat/strand_tile.h"
#include "renderer/pattern/pattern.h"
#include "renderer/pattern/surface_volume.h"
#include "renderer/shaders/constants.h"
#include "renderer/shading/scattering_table.h"

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
  return texture;
}

}  // namespace

CoatTextures::CoatTextures(const Gl& gl, const Coat& coat, const Slices& slices, UploadCount& count)
    : coat_(coat), slices_(without_texels(slices)) {
  shapes_ = send(gl, slices, &SliceLevel::shape, GL_LINEAR, count);
  colours_ = send(gl, slices, &SliceLevel::colour, GL_LINEAR, count);
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

namespace {

struct TuftBlock {
  glm::vec4 origin;  // corner of the volume; w: share gathered at the tip
  glm::vec4 scale;   // 1 / its extent; w: longest vector to a middle, sizes
};

}  // namespace

void TuftTextures::prepare(const Gl& gl, std::uint64_t model_id, const Tufts& tufts, const ModelBuffers& model) {
  if (model_ != model_id || tufts_ != tufts) {
    model_ = model_id, tufts_ = tufts;
    send(gl, tufts, model);
  }
  gl.BindBufferBase(GL_UNIFORM_BUFFER, tuft_binding, uniforms_.id());
  gl.BindTextureUnit(tuft_unit, volume_.id());
}

void TuftTextures::send(const Gl& gl, const Tufts& tufts, const ModelBuffers& model) {
  const float longest = longest_pull(tufts);
  const SurfaceVolume volume = make_surface_volume(model.surface(), [&](const RestPosePoint& middle) {
    const TuftPull tuft = tuft_at(tufts, middle);
    return glm::vec4(0.5f + 0.5f * tuft.to_middle / longest, tuft.inside);
  });
  volume_ = volume_texture(gl, volume);
  const TuftBlock block{{volume.origin, gathered(tufts, 1)}, {1.0f / (glm::vec3(volume.size) * volume.cell), longest}};
  gl.NamedBufferData(uniforms_.id(), sizeof block, &block, GL_STATIC_DRAW);
}

namespace {

struct PatternColours {
  glm::vec4 colour, inner_colour, belly_colour, origin, scale;
};

}  // namespace

void PatternTextures::prepare(const Gl& gl, std::uint64_t model_id, const Coat& coat, ModelBuffers& model) {
  const PatternBlock block = make_pattern_block(coat);
  if (model_ != model_id || block_ != block) {
    model_ = model_id, block_ = block;
    send_volume(gl, block, model);
    std::vector<glm::vec4> variation;
    variation.reserve(model.positions().size());
    for (const glm::vec3& position : model.rest_pose_positions())
      variation.push_back(pattern_variation(block, position));
    model.send_variation(gl, variation);
  }
  gl.BindBufferBase(GL_UNIFORM_BUFFER, pattern_binding, uniforms_.id());
  gl.BindTextureUnit(pattern_unit, volume_.id());
}

void PatternTextures::send_volume(const Gl& gl, const PatternBlock& block, const ModelBuffers& model) {
  const SurfaceVolume volume = make_surface_volume(model.surface(), [&](const RestPosePoint& middle) {
    return glm::vec4(pattern_weights(block, middle.position, middle.normal), 1);
  });
  volume_ = volume_texture(gl, volume);
  const PatternColours colours{block.colour,
                               block.inner_colour,
                               block.belly_colour,
                               {volume.origin, block.axis.w},
                               {1.0f / (glm::vec3(volume.size) * volume.cell), 0}};
  gl.NamedBufferData(uniforms_.id(), sizeof colours, &colours, GL_STATIC_DRAW);
}

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
  const Look look = wet_look(frame.wetness(), frame.look);
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
