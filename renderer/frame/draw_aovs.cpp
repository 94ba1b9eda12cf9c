// What a frame keeps beside colour.
#include <algorithm>
#include <optional>

#include "renderer/frame/gl_renderer.h"
#include "renderer/frame/parts.h"
#include "renderer/gl/sync.h"
#include "renderer/passes/draw/draw.h"

namespace pelage {

void GlRenderer::draw_beside_light(const FurFrame& frame, const Prepared& scene, const AovTarget& target) {
  set_draw_state(gl_, target.framebuffer(), target.width(), target.height());
  gl_.DepthMask(GL_TRUE);
  target.clear(gl_);
  draw_body(frame, scene, "#define AOVS\n");
}

Result<std::vector<FloatImage>> GlRenderer::draw_aovs(const FurFrame& frame, std::span<const Aov> aovs,
                                                      DrawTimes* times, const Pause& pause) {
  if (const Status status = prepare_targets(frame, GL_RGBA32F); !status.ok()) return status;
  DrawTimes taken;
  const Result<Prepared> scene = draw_in_pieces(frame, pause, taken);
  if (!scene) return scene.status();
  Result<std::vector<FloatImage>> images = gather_aovs(frame, *scene, aovs, taken);
  if (!images) return images;
  if (const Status built = programs(); !built.ok()) return built;
  add_counts(taken.counters, take_counts());
  if (times) *times = taken;
  drop_large_targets();
  return images;
}

Result<std::vector<FloatImage>> GlRenderer::gather_aovs(const FurFrame& frame, const Prepared& scene,
                                                        std::span<const Aov> aovs, DrawTimes& times) {
  const DrawClock clock(times);
  std::optional<AovTarget> target;
  if (std::any_of(aovs.begin(), aovs.end(), AovTarget::holds)) {
    target.emplace(gl_, aovs, targets_.drawn.width(), targets_.drawn.height());
    if (!target->complete()) return no_memory_for_frame();
    draw_beside_light(frame, scene, *target);
  }
  std::vector<FloatImage> images;
  for (const Aov aov : aovs) {
    Result<FloatImage> image = draw_aov(frame, scene, aov, target ? &*target : nullptr);
    if (!image) return image.status();
    images.push_back(std::move(image).value());
  }
  return images;
}

Result<FloatImage> GlRenderer::draw_aov(const FurFrame& frame, const Prepared& scene, Aov aov,
                                        const AovTarget* target) {
  RenderTarget distance;
  GLuint source = targets_.drawn.texture();
  if (aov == Aov::depth) {
    distance = RenderTarget(gl_, GL_R32F, targets_.drawn.width(), targets_.drawn.height(), true);
    const RenderTarget covered(gl_, GL_RG32F, targets_.drawn.width(), targets_.drawn.height(), true);
    if (!distance.complete() || !covered.complete()) return no_memory_for_frame();
    aovs_.draw_distance(gl_, {fur_, guard_hairs_, curves_, eyes_}, frame, scene.drawing(frame), distance, covered);
    source = distance.texture();
  } else if (AovTarget::holds(aov)) {
    source = target->texture(aov);
  }
  const float scale = static_cast<float>(targets_.drawn.height()) / static_cast<float>(frame.height);
  aovs_.gather(gl_, aov, source, scale, targets_.picture);
  if (const Status answer = wait_for(gl_); !answer.ok()) return answer;
  return read_back<FloatImage>(targets_.picture, GL_FLOAT);
}

}  // namespace pelage
