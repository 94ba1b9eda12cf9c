// The GL side of traced strands: what they stand on, and their picture as it is shown.
#include <algorithm>
#include <array>
#include <cassert>

#include "renderer/frame/gl_renderer.h"
#include "renderer/frame/parts.h"
#include "renderer/gl/sync.h"
#include "renderer/passes/draw/draw.h"

namespace pelage {

namespace {

constexpr int max_base_pixels = 2048;  // along a side, of a picture that is larger than its frame

/// The frame as its skin and eyes are drawn: what a knob, the ground and curves would add is left out.
FurFrame open_frame(const FurFrame& frame) {
  const int factor = 2 * std::max(frame.width, frame.height) <= max_base_pixels ? 2 : 1;
  FurFrame open = frame;
  open.width *= factor, open.height *= factor;
  open.knobs = {};
  open.knobs.scale = 1, open.knobs.self_shadow = false, open.knobs.shadow_maps = false;
  open.knobs.eye_steps = frame.knobs.eye_steps;
  open.ground.reset();
  open.curves.clear();
  return open;
}

}  // namespace

Result<Backplate> GlRenderer::draw_backplate(const FurFrame& asked, DrawTimes* times) {
  const FurFrame frame = open_frame(asked);
  if (const Status status = prepare_targets(frame, GL_RGBA32F); !status.ok()) return status;
  const Stopwatch drawing;
  fragments_.begin();
  assert(has(frame.model));
  ModelBuffers& model = models_.at(frame.model);
  const ModelBuffers::DrawLists lists = model.skin_lists(gl_);
  prepare_colours(frame, model);
  bind_blocks(frame, make_frame_block(frame, Slices{}, model.has_colours(), frame.height));
  set_draw_state(gl_, targets_.drawn);
  gl_.DepthMask(GL_TRUE);
  clear_target(gl_, targets_.drawn, {});
  draw_open_body(frame, model, lists, "");
  fragments_.end();
  const AovTarget aovs(gl_, std::array{Aov::direct, Aov::albedo, Aov::normal}, frame.width, frame.height);
  const RenderTarget distance(gl_, GL_R32F, frame.width, frame.height, true);
  if (!aovs.complete() || !distance.complete()) return no_memory();
  set_draw_state(gl_, aovs.framebuffer(), frame.width, frame.height);
  gl_.DepthMask(GL_TRUE);
  aovs.clear(gl_);
  draw_open_body(frame, model, lists, "#define AOVS\n");
  aovs_.draw_open_distance(gl_, eyes_, frame, model, lists.all, distance);
  Result<Backplate> base = read_backplate(aovs, distance);
  if (const Status built = programs(); !built.ok()) return built;
  if (times) *times = {.draw = drawing.milliseconds(), .counters = take_counters()};
  drop_large_targets();
  return base;
}

void GlRenderer::draw_open_body(const FurFrame& frame, const ModelBuffers& model, const ModelBuffers::DrawLists& lists,
                                const std::string& outputs) {
  const std::string variant = light_of(frame, model.has_colours()) + shape_of(frame.coat, model) + outputs;
  fur_.draw_open_skin(gl_, model, lists, variant);
  if (!frame.eyes.empty()) eyes_.draw(gl_, frame, outputs);
}

Result<Backplate> GlRenderer::read_backplate(const AovTarget& aovs, const RenderTarget& distance) {
  struct Part {
    Aov aov;
    GLuint texture;
    FloatImage Backplate::*image;
  };
  const auto texture = [&](Aov aov) { return aovs.texture(aov); };
  Backplate base;
  for (const Part& part : {Part{Aov::beauty, targets_.drawn.texture(), &Backplate::beauty},
                           Part{Aov::direct, texture(Aov::direct), &Backplate::direct},
                           Part{Aov::albedo, texture(Aov::albedo), &Backplate::albedo},
                           Part{Aov::normal, texture(Aov::normal), &Backplate::normal},
                           Part{Aov::depth, distance.texture(), &Backplate::depth}}) {
    aovs_.gather(gl_, part.aov, part.texture, 1.0f, targets_.picture);
    if (const Status answer = wait_for(gl_); !answer.ok()) return answer;
    Result<FloatImage> image = read_back<FloatImage>(targets_.picture, GL_FLOAT);
    if (!image) return image.status();
    base.*part.image = std::move(image).value();
  }
  return base;
}

Result<Image> GlRenderer::finish(const FurFrame& frame, const FloatImage& light, DrawTimes* times) {
  return finish_picture<Image>(frame, light, GL_RGBA8, GL_UNSIGNED_BYTE, 255, times);
}

Result<Image16> GlRenderer::finish_deep(const FurFrame& frame, const FloatImage& light, DrawTimes* times) {
  return finish_picture<Image16>(frame, light, GL_RGBA16, GL_UNSIGNED_SHORT, 65535, times);
}

template <class Picture>
Result<Picture> GlRenderer::finish_picture(const FurFrame& frame, const FloatImage& light, GLenum format, GLenum type,
                                           int largest, DrawTimes* times) {
  assert(light.width == frame.width && light.height == frame.height);
  const Stopwatch drawing;
  const RenderTarget traced(gl_, GL_RGBA32F, frame.width, frame.height, false);
  const RenderTarget picture(gl_, format, frame.width, frame.height, false);
  if (!traced.complete() || !picture.complete()) return no_memory();
  gl_.TextureSubImage2D(traced.texture(), 0, 0, 0, frame.width, frame.height, GL_RGBA, GL_FLOAT, light.rgba.data());
  const Result<RenderTarget> overlay = overlay_on_traced(frame);
  if (!overlay) return overlay.status();
  fragments_.begin();
  resolve_.draw(gl_, frame, traced, picture, largest, overlay->texture());
  fragments_.end();
  if (const Status built = programs(); !built.ok()) return built;
  if (const Status answer = wait_for(gl_); !answer.ok()) return answer;
  const double drawn = drawing.milliseconds();
  Result<Picture> image = read_back<Picture>(picture, type);
  if (times) *times = {.draw = drawn, .read = drawing.milliseconds() - drawn, .counters = take_counters()};
  return image;
}

Result<RenderTarget> GlRenderer::overlay_on_traced(const FurFrame& frame) {
  if (frame.overlay == Overlay::none) return RenderTarget();
  if (frame.overlay == Overlay::shell_count || OverlayPass::is_map(frame.overlay))
    return failure(Code::invalid, "Traced strands have no such map.", "/overlay");
  assert(has(frame.model));
  ModelBuffers& model = models_.at(frame.model);
  bind_blocks(frame, make_frame_block(frame, Slices{}, model.has_colours(), frame.height));
  return draw_skin_overlay(frame, model, model.skin_lists(gl_).all);
}

}  // namespace pelage
