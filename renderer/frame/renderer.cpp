#include "renderer/frame/renderer.h"

#include <array>
#include <cassert>
#include <utility>

#include "renderer/frame/draw_clock.h"
#include "renderer/frame/draw_times.h"
#include "renderer/image/cropped.h"
#include "renderer/overlay/field_picture.h"

namespace pelage {

namespace {

/// A frame's crop of a picture of the frame's size; all of it without one.
template <class Picture>
Picture crop_of(const FurFrame& frame, Picture whole) {
  if (!frame.crop) return whole;
  return cropped(whole, frame.crop->left, frame.crop->top, frame.crop->width, frame.crop->height);
}

template <class Picture>
Result<Picture> crop_of(const FurFrame& frame, Result<Picture> whole) {
  if (!whole || !frame.crop) return whole;
  return crop_of(frame, std::move(whole).value());
}

}  // namespace

Result<std::unique_ptr<Renderer>> Renderer::create(const Gl& gl, const RendererOptions& options) {
  Result<std::unique_ptr<GlRenderer>> passes = GlRenderer::create(gl, options.sorted_bytes, options.coats);
  if (!passes) return passes.status();
  auto renderer = std::make_unique<Renderer>(options);
  renderer->gl_ = std::move(passes).value();
  return renderer;
}

UploadCount Renderer::add(const FurModel& model, const FurFields& fields) {
  const UploadCount taken = marched_.add(model, fields);
  return gl_ ? gl_->add(model, fields) : taken;
}

UploadCount Renderer::add_strands(const FurModel& model, const FurFields& fields) {
  return {raster_.add(model, fields), 1};
}

UploadCount Renderer::update(std::uint64_t model, const FurFields& fields) {
  const UploadCount taken = marched_.update(model, fields);
  if (raster_.has(model)) raster_.update(model, fields);
  return gl_ ? gl_->update(model, fields) : taken;
}

Result<FloatImage> Renderer::overlay_over_gl(const FurFrame& frame, const Pause& pause) {
  if (frame.overlay == Overlay::none) return FloatImage();
  if (frame.overlay != Overlay::shell_count) return marched_.overlay(frame);
  const Result<std::vector<FloatImage>> counts = gl_->draw_aovs(frame, std::array{Aov::shell_count}, nullptr, pause);
  if (!counts) return counts.status();
  return count_overlay(counts->front(), frame.knobs.shells);
}

template <class Picture, class Draw>
Result<Picture> Renderer::draw_by_gl(const FurFrame& frame, DrawTimes* times, const Pause& pause, const Draw& draw) {
  DrawTimes taken;
  Result<FloatImage> overlay = FloatImage();
  {
    const DrawClock clock(taken);
    overlay = overlay_over_gl(frame, pause);
  }
  if (!overlay) return overlay.status();
  DrawTimes drawn;
  Result<Picture> picture = draw(overlay->rgba.empty() ? nullptr : &*overlay, &drawn);
  add_times(drawn, taken);
  if (times) *times = drawn;
  return picture;
}

Result<FloatImage> Renderer::overlay_of_strands(const FurFrame& frame, DrawTimes& times, const Pause& pause) {
  if (frame.overlay == Overlay::none) return FloatImage();
  assert(!is_field(frame.overlay) || rasterizes(frame.model));
  if (is_field(frame.overlay)) return raster_.field_overlay(frame, times, pause);
  const DrawClock clock(times);
  return marched_.shape_overlay(frame);
}

template <class Picture, class Draw>
Result<Picture> Renderer::draw_raster(const FurFrame& frame, DrawTimes* times, const Pause& pause, const Draw& draw) {
  DrawTimes taken;
  const Result<FloatImage> overlay = overlay_of_strands(frame, taken, pause);
  if (!overlay) return overlay.status();
  Result<Picture> picture = draw(overlay->rgba.empty() ? nullptr : &*overlay, taken);
  if (times) *times = taken;
  return crop_of(frame, std::move(picture));
}

Result<Image> Renderer::draw(const FurFrame& frame, DrawTimes* times, const Pause& pause) {
  if (frame.knobs.method == Method::raster)
    return draw_raster<Image>(frame, times, pause, [&](const FloatImage* overlay, DrawTimes& taken) {
      return raster_.draw(frame, overlay, taken, pause);
    });
  if (!gl_) return crop_of(frame, marched_.draw(frame, times, pause));
  return draw_by_gl<Image>(frame, times, pause, [&](const FloatImage* overlay, DrawTimes* drawn) {
    return crop_of(frame, gl_->draw(frame, overlay, drawn, pause));
  });
}

Result<Image16> Renderer::draw_deep(const FurFrame& frame, DrawTimes* times, const Pause& pause) {
  if (frame.knobs.method == Method::raster)
    return draw_raster<Image16>(frame, times, pause, [&](const FloatImage* overlay, DrawTimes& taken) {
      return raster_.draw_deep(frame, overlay, taken, pause);
    });
  if (!gl_) return crop_of(frame, marched_.draw_deep(frame, times, pause));
  return draw_by_gl<Image16>(frame, times, pause, [&](const FloatImage* overlay, DrawTimes* drawn) {
    return crop_of(frame, gl_->draw_deep(frame, overlay, drawn, pause));
  });
}

Result<std::vector<FloatImage>> Renderer::draw_aovs(const FurFrame& frame, std::span<const Aov> aovs, DrawTimes* times,
                                                    const Pause& pause) {
  DrawTimes taken;
  auto images = frame.knobs.method == Method::raster ? raster_.draw_aovs(frame, aovs, taken, pause)
                : gl_                                ? gl_->draw_aovs(frame, aovs, &taken, pause)
                                                     : marched_.draw_aovs(frame, aovs, &taken, pause);
  if (times) *times = taken;
  if (!images || !frame.crop) return images;
  for (FloatImage& image : *images) image = crop_of(frame, std::move(image));
  return images;
}

Result<Backplate> Renderer::draw_backplate(const FurFrame& frame, DrawTimes* times) {
  return marched_.draw_backplate(frame, times);
}

template <class Picture, class Finish>
Result<Picture> Renderer::finish_traced(const FurFrame& frame, const FloatImage& light, DrawTimes* times,
                                        const Finish& finish) {
  assert(light.width == frame.width && light.height == frame.height);
  DrawTimes taken;
  const Result<FloatImage> overlay = overlay_of_strands(frame, taken, {});
  if (!overlay) return overlay.status();
  Picture picture;
  {
    const DrawClock clock(taken);
    picture = finish(frame, FinishInput{light, overlay->rgba.empty() ? nullptr : &*overlay, threads_});
  }
  if (times) *times = taken;
  return crop_of(frame, std::move(picture));
}

Result<Image> Renderer::finish(const FurFrame& frame, const FloatImage& light, DrawTimes* times) {
  return finish_traced<Image>(frame, light, times, finish_picture);
}

Result<Image16> Renderer::finish_deep(const FurFrame& frame, const FloatImage& light, DrawTimes* times) {
  return finish_traced<Image16>(frame, light, times, finish_picture_deep);
}

void Renderer::clear_view_cache() { marched_.clear_view_cache(), raster_.clear_view_cache(); }

std::size_t Renderer::bytes_of(std::uint64_t original) const {
  return (gl_ ? gl_->bytes_of(original) : 0) + marched_.bytes_of(original) + raster_.bytes_of(original);
}

void Renderer::forget(std::uint64_t original) {
  marched_.forget(original), raster_.forget(original);
  if (gl_) gl_->forget(original);
}

void Renderer::forget_all() {
  marched_.forget_all(), raster_.forget_all();
  if (gl_) gl_->forget_all();
}

}  // namespace pelage
