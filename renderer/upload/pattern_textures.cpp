#include "renderer/upload/pattern_textures.h"

#include <vector>

#include "renderer/pattern/pattern.h"
#include "renderer/pattern/surface_volume.h"
#include "renderer/shaders/constants.h"
#include "renderer/upload/textures.h"

namespace pelage {

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
    for (const glm::vec3& place : model.positions()) variation.push_back(pattern_variation(block, place));
    model.send_variation(gl, variation);
  }
  gl.BindBufferBase(GL_UNIFORM_BUFFER, pattern_binding, uniforms_.id());
  gl.BindTextureUnit(pattern_unit, volume_.id());
}

void PatternTextures::send_volume(const Gl& gl, const PatternBlock& block, const ModelBuffers& model) {
  const SurfaceVolume volume = make_surface_volume(
      {model.positions(), model.normals(), model.triangles()},
      [&](glm::vec3 middle, glm::vec3 normal) { return glm::vec4(pattern_weights(block, middle, normal), 1); });
  volume_ = volume_texture(gl, volume);
  const PatternColours colours{block.colour,
                               block.inner_colour,
                               block.belly_colour,
                               {volume.origin, block.axis.w},
                               {1.0f / (glm::vec3(volume.size) * volume.cell), 0}};
  gl.NamedBufferData(uniforms_.id(), sizeof colours, &colours, GL_STATIC_DRAW);
}

}  // namespace pelage
