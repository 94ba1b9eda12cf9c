#include "renderer/frame/shadow_maps.h"

#include <algorithm>

#include "renderer/passes/draw/draw_state.h"

namespace pelage {

namespace {

constexpr float half_diagonal = 0.5f;  // of every model's box, sizes

bool has_maps(const FurLight& light) { return light.self_shadow_maps || light.cast_shadow != CastShadow::none; }

/// The paper reduces to a quarter at 512 x 512; the blur must not shrink with finer maps, so a texel is about .03 sizes
/// wide (a quarter of what smaller maps have).
int width_texels(int resolution) {
  int ratio = 4;
  while (resolution / ratio > 48) ratio *= 2;
  return std::max(1, resolution / ratio);
}

Texture map_array(const Gl& gl, GLenum format, int size, int slices, GLint filter) {
  Texture texture(gl, GLenum{GL_TEXTURE_2D_ARRAY});
  gl.TextureStorage3D(texture.id(), 1, format, size, size, std::max(1, slices));
  for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TextureParameteri(texture.id(), name, filter);
  for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl.TextureParameteri(texture.id(), name, GL_CLAMP_TO_EDGE);
  return texture;
}

}  // namespace

ShadowMaps::ShadowMaps(const Gl& gl) : shells_(gl), scene_(gl), view_block_(gl), shadow_block_(gl) {
  gl.NamedBufferData(view_block_.id(), sizeof(FrameBlock), nullptr, GL_STREAM_DRAW);
  gl.NamedBufferData(shadow_block_.id(), sizeof(ShadowBlock), nullptr, GL_STREAM_DRAW);
}

bool ShadowMaps::wanted(const FurFrame& frame) {
  return frame.knobs.shadow_maps && std::any_of(frame.lights.begin(), frame.lights.end(), has_maps);
}

bool ShadowMaps::prepare(const Gl& gl, const FurFrame& frame, const FrameBlock& block, const ModelBuffers& model,
                         const CoatTextures& coat, const ModelBuffers::DrawLists& lists) {
  Key key{frame.model, model.version(), frame.coat, frame.lights, frame.knobs.shadow_resolution};
  if (key == key_) {
    bind(gl);
    return false;
  }
  key_ = std::move(key);
  std::vector<LightView> views;
  const Counts counts = place_slots(frame, half_diagonal + model.longest_fur(), views);
  make_textures(gl, counts, frame.knobs.shadow_resolution);
  gl.NamedBufferSubData(shadow_block_.id(), 0, sizeof(ShadowBlock), &slots_);
  gl.BindVertexArray(model.vertex_array());
  gl.BindTextureUnit(0, coat.shapes());
  gl.BindTextureUnit(1, coat.colours());
  gl.BindTextureUnit(2, model.base_images());
  draw_maps(gl, block, views, lists.all, frame.knobs.shadow_resolution);
  bind(gl);
  return true;
}

ShadowMaps::Counts ShadowMaps::place_slots(const FurFrame& frame, float radius, std::vector<LightView>& views) {
  Counts counts;
  slots_ = {};
  for (std::size_t i = 0; i < frame.lights.size(); ++i) {
    const FurLight& light = frame.lights[i];
    slots_.slots[i] = {-1, -1, 0, 0};
    const auto view = has_maps(light) ? view_of_light(light, radius, frame.knobs.shadow_resolution) : std::nullopt;
    if (!view) continue;
    slots_.to_light[i] = view->world_to_clip;
    slots_.axis[i] = view->axis;
    const bool casts = light.cast_shadow != CastShadow::none;
    slots_.slots[i] = {light.self_shadow_maps ? static_cast<float>(counts.layers++) : -1.0f,
                       static_cast<float>(counts.casts++), light.cast_shadow == CastShadow::soft ? 1.0f : 0.0f,
                       casts ? light.shadow_scale : -1.0f};
    views.push_back(*view);
  }
  return counts;
}

void ShadowMaps::make_textures(const Gl& gl, const Counts& counts, int resolution) {
  kept_ = map_array(gl, GL_R16F, counts.layers ? resolution : 1, counts.layers * shadow_boundaries, GL_LINEAR);
  depth_ = map_array(gl, GL_R32F, resolution, counts.casts, GL_NEAREST);
  width_ = map_array(gl, GL_R16F, width_texels(resolution), counts.casts, GL_LINEAR);
}

void ShadowMaps::draw_maps(const Gl& gl, const FrameBlock& block, const std::vector<LightView>& views,
                           const ModelBuffers::DrawList& triangles, int resolution) {
  const RenderTarget kept(gl, GL_R16F, resolution, resolution, 1, true),
      depth(gl, GL_R32F, resolution, resolution, 1, true);
  const RenderTarget width(gl, GL_R16F, width_texels(resolution), width_texels(resolution), 1, false);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, 0, view_block_.id());
  std::size_t next = 0;
  for (const glm::vec4& slot : slots_.slots) {
    if (slot.y < 0 || next == views.size()) continue;
    const LightView& view = views[next++];
    FrameBlock seen = block;
    seen.world_to_clip = view.world_to_clip;
    seen.eye = {view.eye, view.texel};
    gl.NamedBufferSubData(view_block_.id(), 0, sizeof(FrameBlock), &seen);
    scene_.draw(gl, triangles, view, {depth, kept, width}, depth_.id(), width_.id(), static_cast<int>(slot.y));
    if (slot.x >= 0) shells_.draw(gl, triangles, kept, kept_.id(), static_cast<int>(slot.x) * shadow_boundaries);
  }
}

void ShadowMaps::bind(const Gl& gl) const {
  gl.BindBufferBase(GL_UNIFORM_BUFFER, 2, shadow_block_.id());
  gl.BindTextureUnit(4, kept_.id());
  gl.BindTextureUnit(5, depth_.id());
  gl.BindTextureUnit(6, width_.id());
}

}  // namespace pelage
