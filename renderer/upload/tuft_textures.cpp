#include "renderer/upload/tuft_textures.h"

#include "renderer/shaders/constants.h"
#include "renderer/upload/textures.h"

namespace pelage {

namespace {

struct TuftBlock {
  glm::vec4 origin;  // of the volume; w: gathered at the tip
  glm::vec4 scale;   // 1 / its extent; w: the longest pull
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
  const SurfaceVolume volume = make_surface_volume(
      {model.positions(), model.normals(), model.triangles()}, [&](glm::vec3 middle, glm::vec3 normal) {
        const TuftPlace tuft = tuft_at(tufts, middle, normal);
        return glm::vec4(0.5f + 0.5f * tuft.to_middle / longest, tuft.inside);
      });
  volume_ = volume_texture(gl, volume);
  const TuftBlock block{{volume.origin, gathered(tufts, 1)}, {1.0f / (glm::vec3(volume.size) * volume.cell), longest}};
  gl.NamedBufferData(uniforms_.id(), sizeof block, &block, GL_STATIC_DRAW);
}

}  // namespace pelage
