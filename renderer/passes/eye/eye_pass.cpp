#include "renderer/passes/eye/eye_pass.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "protocol/base/limits.h"
#include "renderer/eye/eye_block.h"
#include "renderer/eye/iris_map.h"
#include "renderer/eye/optics.h"
#include "renderer/shaders/constants.h"

namespace pelage {

namespace shaders {
extern const char* const eye_vert;
extern const char* const eye_frag;
}  // namespace shaders

namespace {

constexpr int vertices_of_box = 36;

Texture make_texture(const Gl& gl, GLenum format, int levels, int width, int height, int count, GLenum across) {
  Texture texture(gl, GLenum{GL_TEXTURE_2D_ARRAY});
  gl.TextureStorage3D(texture.id(), levels, format, width, height, count);
  gl.TextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER, levels > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
  gl.TextureParameteri(texture.id(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TextureParameteri(texture.id(), GL_TEXTURE_WRAP_S, static_cast<GLint>(across));
  gl.TextureParameteri(texture.id(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

}  // namespace

EyePass::EyePass(const Gl& gl) : nothing_(gl), block_(gl) {
  gl.NamedBufferData(block_.id(), sizeof(EyeBlock), nullptr, GL_STREAM_DRAW);
}

const Program& EyePass::program_of(const Gl& gl, const std::string& outputs) {
  const auto [place, made] = programs_.try_emplace(outputs, gl, shaders::eye_vert, shaders::eye_frag, outputs);
  if (made) failure_ += place->second.log();
  return place->second;
}

void EyePass::make_textures(const Gl& gl) {
  constexpr int levels = std::bit_width(static_cast<unsigned>(iris_map_height));
  tissues_ = make_texture(gl, GL_RGBA8, levels, iris_map_width, iris_map_height, 1, GL_REPEAT);
  gl.TextureSubImage3D(tissues_.id(), 0, 0, 0, 0, iris_map_width, iris_map_height, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                       make_iris_map().data());
  gl.GenerateTextureMipmap(tissues_.id());
  cache_.resize(limits::eyes);
  caustics_ = make_texture(gl, GL_R32F, 1, caustic_texels, caustic_texels,
                           caustic_angles * static_cast<int>(cache_.size()), GL_CLAMP_TO_EDGE);
}

int EyePass::caustics_of(const Gl& gl, const EyeShape& shape) {
  auto place = std::find_if(cache_.begin(), cache_.end(), [&](const Cached& kept) { return kept.shape == shape; });
  const bool made = place != cache_.end();
  const auto older = [](const Cached& a, const Cached& b) { return a.used < b.used; };
  if (!made) place = std::min_element(cache_.begin(), cache_.end(), older);
  const int first = caustic_angles * static_cast<int>(place - cache_.begin());
  *place = {shape, draws_};
  if (made) return first;
  gl.TextureSubImage3D(caustics_.id(), 0, 0, 0, first, caustic_texels, caustic_texels, caustic_angles, GL_RED, GL_FLOAT,
                       gather_caustics(shape).data());
  return first;
}

void EyePass::draw(const Gl& gl, const FurFrame& frame, const std::string& outputs) {
  assert(!frame.eyes.empty() && frame.eyes.size() <= limits::eyes);
  if (!tissues_) make_textures(gl);
  ++draws_;
  EyeBlock block;
  block.surroundings = {frame.background_colour, 1};
  for (std::size_t k = 0; k < frame.eyes.size(); ++k) {
    block.eyes[k] = make_eye_entry(frame.eyes[k], frame, caustics_of(gl, shape_of(frame.eyes[k])));
  }
  gl.NamedBufferSubData(block_.id(), 0, sizeof(EyeBlock), &block);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, eye_binding, block_.id());
  gl.BindVertexArray(nothing_.id());
  gl.BindTextureUnit(tissues_unit, tissues_.id());
  gl.BindTextureUnit(caustics_unit, caustics_.id());
  gl.Enable(GL_BLEND);  // for the softened silhouette
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl.Enable(GL_CULL_FACE);  // one side of the box, the far one: a camera inside the box still sees it
  const Program& program = program_of(gl, outputs);
  program.use();
  program.set("steps", frame.knobs.eye_steps);
  gl.DrawArrays(GL_TRIANGLES, 0, vertices_of_box * static_cast<int>(frame.eyes.size()));
  gl.Disable(GL_CULL_FACE);
  gl.Disable(GL_BLEND);
}

}  // namespace pelage
