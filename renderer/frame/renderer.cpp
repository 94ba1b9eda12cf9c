#include "renderer/frame/renderer.h"

#include <cassert>
#include <utility>

#include "renderer/finish/resize.h"
#include "renderer/frame/draw_clock.h"
#include "renderer/image/cropped.h"
#include "renderer/overlay/field_picture.h"

namespace pelage {

namespace {

/// Returns a frame's crop of a picture of the frame's size, or all of it without a crop.
template <class Picture>
Picture crop_of(const FurFrame& frame, Picture full_frame) {
  if (!frame.crop) return full_frame;
  return cropped(full_frame, frame.crop->left, frame.crop->top, frame.crop->width, frame.crop->height);
}

bool is_layered(const FurFrame& frame) { return frame.knobs.method == Method::shells; }

/// Returns light resized to the frame's picture.
FloatImage fitted(const FurFrame& frame, FloatImage light, int threads) {
  if (light.width == frame.width && light.height == frame.height) return light;
  return resized_light(light, frame.width, frame.height, threads);
}

}  // namespace

Result<std::unique_ptr<Renderer>> Renderer::create(const Gl& gl, const RendererOptions& options) {
  auto renderer = std::make_unique<Renderer>(options);
  if (Status taken = renderer->take_gl(&gl); !taken.ok()) return taken;
  return renderer;
}

Status Renderer::take_gl(const Gl* gl) {
  shells_.reset();
  raster_.take_gl(gl && (options_.software_gl_draws_strands || !gl->is_software()) ? gl : nullptr);
  if (!gl) return {};
  Result<std::unique_ptr<ShellsRenderer>> shells = ShellsRenderer::create(*gl, options_.sorted_bytes, options_.coats);
  if (!shells) return shells.status();
  shells_ = std::move(shells).value();
  return {};
}

UploadCount Renderer::add(const FurModel& model, EachCoat<FurFields> fields) { return {raster_.add(model, fields)}; }

UploadCount Renderer::add_shells(const FurModel& model, EachCoat<FurFields> fields) {
  return shells_ ? shells_->add(model, fields.front()) : UploadCount{};
}

UploadCount Renderer::update(std::uint64_t model, EachCoat<FurFields> fields) {
  const UploadCount taken{raster_.update(model, fields)};
  return has_shells(model) ? shells_->update(model, fields.front()) : taken;
}

Status Renderer::can_draw(const FurFrame& frame) const {
  if (!is_layered(frame)) return {};
  if (frame.coats.size() > 1)
    return failure(Code::invalid, "Shells draw a single coat.", "/quality/method",
                   "raster or strands, or all coats but one muted");
  if (shells_) return {};
  return failure(Code::invalid, "This server has no GL, which draws shells.", "/quality/method", "raster or strands");
}

bool Renderer::misses_coat(const FurFrame& frame) const {
  return is_layered(frame) && shells_ && shells_->misses_coat(frame);
}

void Renderer::grow(const FurFrame& frame) {
  if (!is_layered(frame)) raster_.grow(frame);
}

Result<FloatImage> Renderer::draw_shells(const FurFrame& frame, DrawTimes& times) {
  assert(shells_);
  const DrawClock clock(times);
  return shells_->draw(frame, times.counters);
}

Result<FloatImage> Renderer::overlay_of(const FurFrame& frame, DrawTimes& times, const Pause& pause) {
  if (frame.overlay == Overlay::none) return FloatImage();
  if (is_field(frame.overlay)) return raster_.field_overlay(frame, times, pause);
  return raster_.shape_overlay(frame, times);
}

template <class Picture, class Draw>
Result<Picture> Renderer::with_overlay(const FurFrame& frame, DrawTimes* times, const Pause& pause, const Draw& draw) {
  DrawTimes taken;
  const Result<FloatImage> overlay = overlay_of(frame, taken, pause);
  if (!overlay) return overlay.status();
  Result<Picture> picture = draw(overlay->rgba.empty() ? nullptr : &*overlay, taken);
  if (times) *times = taken;
  if (!picture) return picture.status();
  return crop_of(frame, std::move(picture).value());
}

Result<Image> Renderer::draw(const FurFrame& frame, DrawTimes* times, const Pause& pause) {
  return with_overlay<Image>(frame, times, pause, [&](const FloatImage* overlay, DrawTimes& taken) -> Result<Image> {
    if (!is_layered(frame)) return raster_.draw(frame, overlay, taken, pause);
    const Result<FloatImage> light = draw_shells(frame, taken);
    if (!light) return light.status();
    return finish_picture(frame, {*light, nullptr, options_.threads});
  });
}

Result<Image16> Renderer::draw_deep(const FurFrame& frame, DrawTimes* times, const Pause& pause) {
  return with_overlay<Image16>(frame, times, pause,
                               [&](const FloatImage* overlay, DrawTimes& taken) -> Result<Image16> {
                                 if (!is_layered(frame)) return raster_.draw_deep(frame, overlay, taken, pause);
                                 const Result<FloatImage> light = draw_shells(frame, taken);
                                 if (!light) return light.status();
                                 return finish_picture_deep(frame, {*light, nullptr, options_.threads});
                               });
}

Result<std::vector<FloatImage>> Renderer::draw_aovs(const FurFrame& frame, std::span<const Aov> aovs, DrawTimes* times,
                                                    const Pause& pause) {
  DrawTimes taken;
  Result<std::vector<FloatImage>> images = std::vector<FloatImage>();
  if (is_layered(frame)) {  // shells have beauty and alpha only
    Result<FloatImage> light = draw_shells(frame, taken);
    if (!light) return light.status();
    images->assign(aovs.size(), fitted(frame, std::move(light).value(), options_.threads));
  } else {
    images = raster_.draw_aovs(frame, aovs, taken, pause);
  }
  if (times) *times = taken;
  if (images && frame.crop)
    for (FloatImage& image : *images) image = crop_of(frame, std::move(image));
  return images;
}

Result<Backplate> Renderer::draw_backplate(const FurFrame& frame, DrawTimes* times) {
  DrawTimes taken;
  Result<Backplate> plate = raster_.draw_backplate(frame, taken);
  if (times) *times = taken;
  return plate;
}

Result<Image> Renderer::finish(const FurFrame& frame, const FloatImage& light, DrawTimes* times) {
  assert(light.width == frame.width && light.height == frame.height);
  return with_overlay<Image>(frame, times, {}, [&](const FloatImage* overlay, DrawTimes& taken) -> Result<Image> {
    const DrawClock clock(taken);
    return finish_picture(frame, {light, overlay, options_.threads});
  });
}

Result<Image16> Renderer::finish_deep(const FurFrame& frame, const FloatImage& light, DrawTimes* times) {
  assert(light.width == frame.width && light.height == frame.height);
  return with_overlay<Image16>(frame, times, {}, [&](const FloatImage* overlay, DrawTimes& taken) -> Result<Image16> {
    const DrawClock clock(taken);
    return finish_picture_deep(frame, {light, overlay, options_.threads});
  });
}

std::size_t Renderer::bytes_of(std::uint64_t original) const {
  return (shells_ ? shells_->bytes_of(original) : 0) + raster_.bytes_of(original);
}

void Renderer::forget(std::uint64_t original) {
  raster_.forget(original);
  if (shells_) shells_->forget(original);
}

void Renderer::forget_all() {
  raster_.forget_all();
  if (shells_) shells_->forget_all();
}

}  // namespace pelage
