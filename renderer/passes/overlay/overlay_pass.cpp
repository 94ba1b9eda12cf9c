#include "renderer/passes/overlay/overlay_pass.h"

#include <algorithm>
#include <cassert>

#include "renderer/passes/draw/draw.h"
#include "renderer/shaders/constants.h"

namespace pelage {

namespace shaders {
extern const char* const whole_target_vert;
extern const char* const field_vert;
extern const char* const field_frag;
extern const char* const difference_vert;
extern const char* const difference_frag;
extern const char* const strokes_frag;
extern const char* const count_frag;
extern const char* const map_frag;
}  // namespace shaders

namespace {

constexpr float strength = 0.6f;     // of colours over the frame
constexpr float full_shells = 2.0f;  // times the shells: what the end of the ramp stands for

enum class FieldKind { direction, strokes, length, density, wetness, mask };  // numbers of field.frag

FieldKind kind_of(Overlay overlay) {
  switch (overlay) {
    case Overlay::direction: return FieldKind::direction;
    case Overlay::strokes: return FieldKind::strokes;
    case Overlay::density: return FieldKind::density;
    case Overlay::wetness: return FieldKind::wetness;
    case Overlay::mask: return FieldKind::mask;
    default: assert(overlay == Overlay::length); return FieldKind::length;
  }
}

}  // namespace

OverlayPass::Programs::Programs(const Gl& gl)
    : field(gl, shaders::field_vert, shaders::field_frag),
      strokes(gl, shaders::whole_target_vert, shaders::strokes_frag),
      count(gl, shaders::whole_target_vert, shaders::count_frag),
      map(gl, shaders::whole_target_vert, shaders::map_frag) {}

OverlayPass::Comparison::Comparison(const Gl& gl)
    : program(gl, shaders::difference_vert, shaders::difference_frag), shares(gl) {}

const OverlayPass::Programs& OverlayPass::programs(const Gl& gl) {
  if (!programs_) programs_.emplace(gl);
  return *programs_;
}

std::string OverlayPass::failure() const {
  const std::string others =
      programs_ ? programs_->field.log() + programs_->strokes.log() + programs_->count.log() + programs_->map.log()
                : "";
  return comparison_ ? others + comparison_->program.log() : others;
}

RenderTarget OverlayPass::begin_skin(const Gl& gl, const FurFrame& frame, const ModelBuffers& model) const {
  RenderTarget field(gl, GL_RGBA16F, frame.width, frame.height, true);
  if (!field.complete()) return field;
  set_draw_state(gl, field);
  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
  clear_target(gl, field, {});
  gl.BindVertexArray(model.vertex_array());
  return field;
}

RenderTarget OverlayPass::draw_field(const Gl& gl, const FurFrame& frame, const ModelBuffers& model,
                                     const ModelBuffers::DrawList& triangles) {
  RenderTarget field = begin_skin(gl, frame, model);
  if (!field.complete()) return field;
  const Programs& with = programs(gl);
  with.field.use();
  with.field.set("aspect", static_cast<float>(frame.width) / static_cast<float>(frame.height));
  with.field.set("kind", static_cast<int>(kind_of(frame.overlay)));
  with.field.set("touched", model.paint().has_numbers() ? 1 : 0);
  with.field.set("longest", model.longest_fur());
  with.field.set("strength", strength);
  draw_list(gl, triangles);
  if (frame.overlay != Overlay::strokes) return field;
  RenderTarget lines(gl, GL_RGBA16F, frame.width, frame.height, false);
  if (!lines.complete()) return lines;
  with.strokes.use();
  draw_whole(gl, lines, field.texture());
  return lines;
}

RenderTarget OverlayPass::draw_difference(const Gl& gl, const FurFrame& frame, const ModelBuffers& model,
                                          const ModelBuffers::DrawList& triangles) {
  RenderTarget target = begin_skin(gl, frame, model);
  if (!target.complete()) return target;
  if (!comparison_) comparison_.emplace(gl);
  std::vector<float> shares;
  shares.reserve(model.welded().size());
  for (const std::uint32_t vertex : model.welded()) shares.push_back(frame.difference[vertex]);
  gl.NamedBufferData(comparison_->shares.id(), static_cast<GLsizeiptr>(shares.size() * sizeof(float)), shares.data(),
                     GL_STREAM_DRAW);
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, pass_storage, comparison_->shares.id());
  comparison_->program.use();
  comparison_->program.set("strength", strength);
  draw_list(gl, triangles);
  return target;
}

RenderTarget OverlayPass::draw_count(const Gl& gl, const FurFrame& frame, GLuint counts, float scale) {
  RenderTarget colours(gl, GL_RGBA16F, frame.width, frame.height, false);
  if (!colours.complete()) return colours;
  const Program& count = programs(gl).count;
  count.use();
  count.set("scale", scale);
  count.set("max_count", full_shells * static_cast<float>(frame.knobs.shells));
  count.set("strength", strength);
  draw_whole(gl, colours, counts);
  return colours;
}

bool OverlayPass::is_map(Overlay overlay) {
  return overlay == Overlay::light_depth || overlay == Overlay::light_occlusion || overlay == Overlay::shadow_width;
}

RenderTarget OverlayPass::draw_map(const Gl& gl, const FurFrame& frame, GLuint map, std::array<float, 2> ends) {
  RenderTarget greys(gl, GL_RGBA16F, frame.width, frame.height, false);
  if (!greys.complete()) return greys;
  for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) gl.TextureParameteri(map, name, GL_CLAMP_TO_EDGE);
  const int side = std::min(frame.width, frame.height);
  const Program& program = programs(gl).map;
  program.use();
  program.set("square", glm::vec3(0.5 * (frame.width - side), 0.5 * (frame.height - side), side));
  program.set("black", ends[0]);
  program.set("white", ends[1]);
  draw_whole(gl, greys, map);
  return greys;
}

void OverlayPass::draw_whole(const Gl& gl, const RenderTarget& target, GLuint source) const {
  gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
  gl.Viewport(0, 0, target.width(), target.height());
  gl.Disable(GL_DEPTH_TEST);
  gl.BindTextureUnit(source_unit, source);
  gl.BindVertexArray(nothing_.id());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace pelage
