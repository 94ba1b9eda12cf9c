#include "renderer/frame/renderer.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "renderer/frame/draw_times.h"

namespace pelage {

Result<std::unique_ptr<Renderer>> Renderer::create(const Gl& gl, const RendererOptions& options) {
  Result<std::unique_ptr<GlRenderer>> passes = GlRenderer::create(gl, options.sorted_bytes);
  if (!passes) return passes.status();
  auto renderer = std::make_unique<Renderer>();
  renderer->gl_ = std::move(passes).value();
  if (options.march_threads > 0) renderer->marched_ = std::make_unique<MarchedRenderer>(options.march_threads);
  return renderer;
}

UploadCount Renderer::add(const FurModel& model, const FurFields& fields) {
  if (marched_) marched_->add(model, fields);
  return gl_->add(model, fields);
}

UploadCount Renderer::update(std::uint64_t model, const FurFields& fields) {
  if (marched_) marched_->update(model, fields);
  return gl_->update(model, fields);
}

template <class Draw>
auto Renderer::march(DrawTimes* times, const Draw& draw) {
  DrawTimes taken;
  auto picture = draw(taken);
  add_counts(taken.counters, gl_->take_counts());
  if (times) *times = taken;
  return picture;
}

Result<Image> Renderer::draw(const FurFrame& frame, DrawTimes* times, const Pause& pause) {
  if (!marches(frame)) return gl_->draw(frame, times, pause);
  return march(times, [&](DrawTimes& taken) { return marched_->draw(frame, &taken, pause); });
}

Result<Image16> Renderer::draw_deep(const FurFrame& frame, DrawTimes* times, const Pause& pause) {
  if (!marches(frame)) return gl_->draw_deep(frame, times, pause);
  return march(times, [&](DrawTimes& taken) { return marched_->draw_deep(frame, &taken, pause); });
}

Result<std::vector<FloatImage>> Renderer::draw_aovs(const FurFrame& frame, std::span<const Aov> aovs, DrawTimes* times,
                                                    const Pause& pause) {
  const auto of_light = [](Aov aov) { return aov == Aov::beauty || aov == Aov::alpha; };
  const bool light = std::any_of(aovs.begin(), aovs.end(), of_light);
  if (!marches(frame) || !light) return gl_->draw_aovs(frame, aovs, times, pause);
  const Result<FloatImage> beauty =
      march(times, [&](DrawTimes& taken) { return marched_->draw_beauty(frame, &taken, pause); });
  if (!beauty) return beauty.status();
  std::vector<Aov> others;
  std::copy_if(aovs.begin(), aovs.end(), std::back_inserter(others), [&](Aov aov) { return !of_light(aov); });
  Result<std::vector<FloatImage>> drawn = std::vector<FloatImage>();
  DrawTimes taken;
  if (!others.empty()) drawn = gl_->draw_aovs(frame, others, &taken, pause);
  if (!drawn) return drawn.status();
  if (times) add_times(*times, taken);
  std::vector<FloatImage> images;
  auto next = drawn->begin();
  for (const Aov aov : aovs) images.push_back(of_light(aov) ? *beauty : std::move(*next++));
  return images;
}

Result<Backplate> Renderer::draw_backplate(const FurFrame& frame, DrawTimes* times) {
  return gl_->draw_backplate(frame, times);
}

Result<Image> Renderer::finish(const FurFrame& frame, const FloatImage& light, DrawTimes* times) {
  return gl_->finish(frame, light, times);
}

Result<Image16> Renderer::finish_deep(const FurFrame& frame, const FloatImage& light, DrawTimes* times) {
  return gl_->finish_deep(frame, light, times);
}

void Renderer::clear_view_cache() {
  if (marched_) marched_->clear_view_cache();
}

std::size_t Renderer::bytes_of(std::uint64_t original) const {
  return gl_->bytes_of(original) + (marched_ ? marched_->bytes_of(original) : 0);
}

void Renderer::forget(std::uint64_t original) {
  if (marched_) marched_->forget(original);
  gl_->forget(original);
}

void Renderer::forget_all() {
  if (marched_) marched_->forget_all();
  gl_->forget_all();
}

}  // namespace pelage
