#include "renderer/shells/shadow_maps.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "renderer/shaders/constants.h"
#include "renderer/shells/draw/draw.h"

namespace pelage {

namespace {

constexpr float half_diagonal = 0.5f;  // half the diagonal of a model's bounding box, sizes: the same for all models

bool casts(const FurLight& light) { return light.cast_shadow != CastShadow::none; }
bool casts_softly(const FurLight& light) { return light.cast_shadow == CastShadow::soft; }
bool casts_penumbra(const FurLight& light) { return light.cast_shadow == CastShadow::penumbra; }
bool has_maps(const FurLight& light) { return light.self_shadow_maps || casts(light); }

/// Returns the entry of ShadowBlock::slots of a light with maps. `shells` and `depth` are the indices of its shell maps
/// and its depth map among those of all lights.
glm::vec4 slots_of(const FurLight& light, float shells, float depth) {
  const glm::vec2 maps{light.self_shadow_maps ? shells : -1.0f, depth};
  if (!casts(light)) return {maps, 0, -1};
  if (casts_penumbra(light)) return {maps, 2, spread_of(light)};
  return {maps, casts_softly(light) ? 1 : 0, light.shadow_scale};
}

/// Returns the side of the shadow-width map, in texels. The paper reduces to a quarter at 512 x 512. The blur must not
/// shrink with finer maps, so at most 48 texels remain, each about .03 sizes wide; smaller maps are reduced to a
/// quarter.
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

void keep(const Gl& gl, const RenderTarget& target, const Texture& maps, int slot) {
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, target.framebuffer());
  gl.CopyTextureSubImage3D(maps.id(), 0, 0, 0, slot, 0, 0, target.width(), target.height());
}

float radius_around(const ModelBuffers& model) { return half_diagonal + model.longest_fur(); }

}  // namespace

ShadowMaps::ShadowMaps(const Gl& gl) : shells_(gl), scene_(gl), view_block_(gl), shadow_block_(gl) {
  gl.NamedBufferData(view_block_.id(), sizeof(FrameBlock), nullptr, GL_STREAM_DRAW);
  gl.NamedBufferData(shadow_block_.id(), sizeof(ShadowBlock), nullptr, GL_STREAM_DRAW);
}

bool ShadowMaps::wanted(const FurFrame& frame) {
  return frame.knobs.shells.shadow_maps && std::any_of(frame.lights.begin(), frame.lights.end(), has_maps);
}

bool ShadowMaps::prepare(const Gl& gl, const FurFrame& frame, const FrameBlock& block, const FurDrawing& drawing) {
  const int resolution = frame.knobs.shells.shadow_resolution;
  Key key{frame.model, drawing.model.version(), frame.coat(), frame.lights, resolution};
  if (key == key_) {
    bind(gl);
    return false;
  }
  key_ = std::move(key);
  std::vector<LightView> views;
  const Counts counts = place_slots(frame, radius_around(drawing.model), views);
  make_textures(gl, counts, resolution);
  gl.NamedBufferSubData(shadow_block_.id(), 0, sizeof(ShadowBlock), &slots_);
  draw_maps(gl, frame, block, views, drawing);
  bind(gl);
  return true;
}

ShadowMaps::Counts ShadowMaps::place_slots(const FurFrame& frame, float radius, std::vector<LightView>& views) {
  Counts counts;
  slots_ = {};
  for (std::size_t i = 0; i < frame.lights.size(); ++i) {
    const FurLight& light = frame.lights[i];
    slots_.slots[i] = {-1, -1, 0, 0};
    const auto view =
        has_maps(light) ? view_of_light(light, radius, frame.knobs.shells.shadow_resolution) : std::nullopt;
    if (!view) continue;
    slots_.to_light[i] = view->world_to_clip;
    slots_.axis[i] = view->axis;
    slots_.slots[i] = slots_of(light, static_cast<float>(counts.shells), static_cast<float>(counts.casts));
    counts.shells += light.self_shadow_maps ? 1 : 0, ++counts.casts;
    views.push_back(*view);
  }
  return counts;
}

void ShadowMaps::make_textures(const Gl& gl, const Counts& counts, int resolution) {
  shell_maps_ = map_array(gl, GL_R16F, counts.shells ? resolution : 1, counts.shells * shadow_boundaries, GL_LINEAR);
  depth_ = map_array(gl, GL_R32F, resolution, counts.casts, GL_NEAREST);
  width_ = map_array(gl, GL_RG32F, width_texels(resolution), counts.casts, GL_LINEAR);
}

void ShadowMaps::bind_light_view(const Gl& gl, const FrameBlock& block, const LightView& view, int resolution) {
  FrameBlock seen = block;
  seen.half_picture = 0.5f * glm::vec4(resolution, -resolution, 0, 0);
  seen.world_to_clip = view.world_to_clip;
  seen.viewpoint = {view.viewpoint, view.texel};
  gl.NamedBufferSubData(view_block_.id(), 0, sizeof(FrameBlock), &seen);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, frame_binding, view_block_.id());
}

void ShadowMaps::draw_maps(const Gl& gl, const FurFrame& frame, const FrameBlock& block,
                           const std::vector<LightView>& views, const FurDrawing& drawing) {
  const int resolution = frame.knobs.shells.shadow_resolution, reduced = width_texels(resolution);
  const RenderTarget transmittance(gl, GL_R16F, resolution, resolution, true),
      depth(gl, GL_R32F, resolution, resolution, true), occlusion(gl, GL_RG32F, resolution, resolution, false),
      width(gl, GL_RG32F, reduced, reduced, false);
  std::size_t next = 0;
  for (std::size_t i = 0; i < slots_.slots.size() && next < views.size(); ++i) {
    const glm::ivec2 slot(slots_.slots[i]);
    if (slot.y < 0) continue;
    const LightView& view = views[next++];
    bind_light_view(gl, block, view, resolution);
    FurPass::bind(gl, drawing);
    if (casts_penumbra(frame.lights[i])) {
      scene_.draw_hull(gl, drawing.lists.all, view, depth);
    } else {
      scene_.draw(gl, drawing.lists.all, view, {depth, occlusion, width});
      keep(gl, width, width_, slot.y);
    }
    keep(gl, depth, depth_, slot.y);
    if (slot.x >= 0)
      shells_.draw(gl, drawing.variant, drawing.lists.all, transmittance, shell_maps_.id(), slot.x * shadow_boundaries);
  }
}

void ShadowMaps::bind(const Gl& gl) const {
  gl.BindBufferBase(GL_UNIFORM_BUFFER, shadow_binding, shadow_block_.id());
  gl.BindTextureUnit(shell_maps_unit, shell_maps_.id());
  gl.BindTextureUnit(depth_maps_unit, depth_.id());
  gl.BindTextureUnit(width_maps_unit, width_.id());
}

}  // namespace pelage
