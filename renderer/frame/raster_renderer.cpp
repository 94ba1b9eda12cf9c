#include "renderer/frame/raster_renderer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <new>
#include <optional>
#include <utility>

#include "renderer/coat/strand_tile.h"
#include "renderer/finish/resize.h"
#include "renderer/frame/areas.h"
#include "renderer/frame/draw_clock.h"
#include "renderer/frame/raster_aovs.h"
#include "renderer/frame/raster_fur.h"
#include "renderer/overlay/field_picture.h"
#include "renderer/raster/changed.h"
#include "renderer/raster/gpu/gpu_raster.h"
#include "renderer/raster/raster.h"
#include "renderer/upload/blocks.h"

namespace pelage {

namespace {

constexpr std::size_t max_bytes = 512u << 20;  // bytes of cached fur of all models but the one being drawn

/// Returns the frame at the size of its light, before that is resized to the picture.
FurFrame scaled(const FurFrame& frame) {
  const auto pixels = [&](int asked) { return std::max(1, static_cast<int>(std::lround(asked * frame.knobs.scale))); };
  FurFrame drawn = frame;
  drawn.width = pixels(frame.width), drawn.height = pixels(frame.height);
  const Area area = drawn_area(frame, {drawn.width, drawn.height});
  if (frame.crop) drawn.crop = Crop{area.left, area.top, area.width, area.height};
  return drawn;
}

/// Returns the crop of a frame, or all of it without one.
Area full_area(const FurFrame& frame) {
  if (!frame.crop) return {0, 0, frame.width, frame.height};
  return {frame.crop->left, frame.crop->top, frame.crop->width, frame.crop->height};
}

/// Returns whether a frame is a draft that draws at most the thin share of each of its coats (keep_strands). Estimated
/// at the distance of the model's centre, for cameras outside the model only.
bool keeps_thin_share(const FurFrame& frame) {
  constexpr double outside = 0.75, of_draft = 0.5;  // distance, sizes; strands a pixel
  const double distance = -double{glm::dot(frame.camera.position, frame.camera.forward)};
  const double pixel = 2 * distance * double{frame.camera.tan_half_fov} / frame.height;
  return distance > outside && std::ranges::all_of(frame.coats, [&](const NamedCoat& one) {
           const Coat& coat = one.coat;
           const RasterQuality quality = quality_of(frame.knobs, winding(coat));
           const double on_a_pixel = expected_strands(pixel * pixel, coat);
           return quality.strands_a_pixel <= of_draft &&
                  quality.drawn_strand_share(on_a_pixel, coat.width_root / pixel) <= thin_share;
         });
}

}  // namespace

RasterRenderer::RasterRenderer(int threads) : threads_(threads), scratch_(std::make_shared<RasterScratch>()) {}
RasterRenderer::~RasterRenderer() = default;

void RasterRenderer::take_gl(const Gl* gl) {
  gpu_.reset();
  views_.invalidate();
  if (!gl) return;
  if (Result<std::unique_ptr<GpuRaster>> made = GpuRaster::create(*gl)) gpu_ = std::move(made).value();
}

bool RasterRenderer::lost_gl() const { return gpu_ && gpu_->lost(); }

bool RasterRenderer::draws_on_gpu(const FurFrame& frame, Growth growth, DrawTimes& times) {
  const DrawClock clock(times);
  if (!gpu_) return false;
  const auto can = [&](bool by_gpu) {
    const RasterFur& raster_fur = grown(frame, {RasterOutput::light, {}, nullptr, growth, by_gpu});
    return gpu_->can_draw(raster_fur.copy.model(), raster_fur.fur);
  };
  // Asks about the fur as it is first, so that it does not grow again for nothing.
  const bool as_it_was = fur_for(frame, growth).bending == Bending::left;
  return can(as_it_was) && can(true);
}

std::size_t RasterRenderer::add(const FurModel& model, EachCoat<FurFields> fields) {
  assert(!has(model.id));
  return models_.try_emplace(model.id, std::make_unique<RasterModel>(model, fields, threads_, scratch_))
      .first->second->copy.bytes();
}

std::size_t RasterRenderer::update(std::uint64_t model, EachCoat<FurFields> fields) {
  return models_.at(model)->copy.update(fields);
}

void RasterRenderer::forget(std::uint64_t original) {
  views_.clear();  // if a model comes again, it is not known what has changed
  if (gpu_) gpu_->forget();
  std::erase_if(models_, [&](const auto& entry) { return entry.second->copy.original() == original; });
}

void RasterRenderer::forget_all() {
  models_.clear(), views_.clear();
  if (gpu_) gpu_->forget();
}

std::size_t RasterRenderer::bytes_of(std::uint64_t original) const {
  std::size_t bytes = 0;
  for (const auto& [id, model] : models_)
    if (model->copy.original() == original) bytes += model->copy.bytes() + model->grown_bytes();
  return bytes;
}

void RasterRenderer::darken(const FurFrame& frame, RasterFur& raster_fur, const Wanted& wanted,
                            FloatImage& picture) const {
  if (!frame.ground || wanted.shown != RasterOutput::light) return;
  const RasterScene scene = scene_of(raster_fur, frame, wanted);
  for (const PixelBox& box : Raster::boxes_of(frame)) raster_fur.raster->darken_box(scene, box, picture);
}

void RasterRenderer::grow(const FurFrame& frame) {
  grown(scaled(frame), {RasterOutput::light, {}, nullptr, Growth::only_drawn, has_gl()});
}

RasterFur& RasterRenderer::fur_for(const FurFrame& frame, Growth growth) {
  RasterModel& own = *models_.at(frame.model);
  return growth == Growth::only_drawn && keeps_thin_share(frame) ? own.thin : own.full;
}

RasterFur& RasterRenderer::grown(const FurFrame& frame, const Wanted& wanted) {
  RasterModel& own = *models_.at(frame.model);
  own.used = ++uses_;
  RasterFur& raster_fur = fur_for(frame, wanted.growth);
  const Bending bending = wanted.by_gpu ? Bending::left : Bending::done;
  raster_fur.grow(own.recipes_for(frame), frame.curves, bending, threads_);
  evict_others(own);
  return raster_fur;
}

void RasterRenderer::evict_others(const RasterModel& own) {
  std::vector<RasterModel*> others;
  std::size_t bytes = 0;
  for (const auto& [id, model] : models_)
    if (model.get() != &own && model->is_grown()) others.push_back(model.get()), bytes += model->grown_bytes();
  std::sort(others.begin(), others.end(), [](const RasterModel* a, const RasterModel* b) { return a->used < b->used; });
  for (auto oldest = others.begin(); oldest != others.end() && bytes > max_bytes; ++oldest) {
    bytes -= (*oldest)->grown_bytes(), (*oldest)->drop(threads_, scratch_);
    if (gpu_) gpu_->forget();
    views_.invalidate();  // it is no longer known what has changed since they were drawn
  }
}

RasterScene RasterRenderer::scene_of(RasterFur& raster_fur, const FurFrame& frame, const Wanted& wanted) const {
  RasterScene scene = raster_fur.raster->scene_of(raster_fur.copy.model(), raster_fur.fur, frame,
                                                  quality_of(frame.knobs, winding(frame.coat())), wanted.shown);
  if (!wanted.by_gpu) raster_fur.raster->fill_cells(scene);
  scene.field = wanted.field, scene.drawn = wanted.tiles, scene.first_object = wanted.first_object;
  return scene;
}

bool RasterRenderer::cpu_takes_over(const Status& failed) {
  if (failed.ok() || failed.code == Code::conflict || lost_gl()) return false;
  if (failed.code == Code::unavailable) take_gl(nullptr);
  return true;
}

Status RasterRenderer::draw_area(const FurFrame& frame, const Area& area, Wanted& wanted, DrawTimes& times,
                                 const Pause& pause, FloatImage& picture) {
  FurFrame part = frame;
  part.crop = Crop{area.left, area.top, area.width, area.height};
  if (wanted.by_gpu) {
    const Status drawn = draw_boxes(frame, Raster::boxes_of(part, gpu_->box_pixels()), wanted, times, pause, picture);
    if (!cpu_takes_over(drawn)) return drawn;
    wanted.by_gpu = false;
  }
  return draw_boxes(frame, Raster::boxes_of(part), wanted, times, pause, picture);
}

Status RasterRenderer::draw_boxes(const FurFrame& frame, std::span<const PixelBox> boxes, const Wanted& wanted,
                                  DrawTimes& times, const Pause& pause, FloatImage& picture) {
  RasterCounts counts;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (i > 0 && pause && !pause()) return drawing_given_up();
    const DrawClock clock(times);
    RasterFur& raster_fur = grown(frame, wanted);  // during the pause it may have grown for another frame
    const RasterScene scene = scene_of(raster_fur, frame, wanted);
    if (!wanted.by_gpu) {
      raster_fur.raster->draw_box(scene, boxes[i], picture, counts);
      continue;
    }
    if (!gpu_) return failure(Code::unavailable, "the GL has gone");  // another drawing lost it during the pause
    if (Status drawn = gpu_->draw_box(scene, boxes[i], picture, counts); !drawn.ok()) return drawn;
  }
  return {};
}

Result<FloatImage> RasterRenderer::draw_full_frame(const FurFrame& frame, Wanted wanted, DrawTimes& times,
                                                   const Pause& pause) {
  wanted.by_gpu = wanted.shown != RasterOutput::objects && draws_on_gpu(frame, wanted.growth, times);
  auto picture = empty_picture<FloatImage>(frame.width, frame.height);
  if (wanted.first_object >= first_coat_object + frame.coats.size()) return picture;  // the frame has no such objects
  if (Status drawn = draw_area(frame, full_area(frame), wanted, times, pause, picture); !drawn.ok()) return drawn;
  const DrawClock clock(times);
  if (!wanted.by_gpu) darken(frame, grown(frame, wanted), wanted, picture);
  return picture;
}

Result<std::vector<FloatImage>> RasterRenderer::draw_aovs(const FurFrame& frame, std::span<const Aov> aovs,
                                                          DrawTimes& times, const Pause& pause) {
  const FurFrame drawn = scaled(frame);
  const bool numbered = std::ranges::any_of(aovs, [](Aov aov) { return output_of(aov) == RasterOutput::strand; });
  const Growth growth = numbered ? Growth::all : Growth::only_drawn;
  std::vector<FloatImage> pictures;
  try {
    std::map<RasterOutput, FloatImage> drawn_before;  // outputs that several AOVs share
    for (const Aov aov : aovs) {
      const RasterOutput shown = output_of(aov);
      const auto before = drawn_before.find(shown);
      Result<FloatImage> image =
          before != drawn_before.end()
              ? before->second
              : draw_full_frame(drawn, {shown, {}, nullptr, growth, false, first_object(aov)}, times, pause);
      if (!image) return image.status();
      const DrawClock clock(times);
      pictures.push_back(aov_picture(frame, aov, *image, fur_for(drawn, growth).fur.parts(), threads_));
      if (shown == RasterOutput::light || shown == RasterOutput::strand)
        drawn_before.insert_or_assign(shown, std::move(*image));
    }
  } catch (const std::bad_alloc&) {
    return no_memory_for_frame();
  }
  times.counters.redrawn = 1;
  return pictures;
}

Result<FloatImage> RasterRenderer::field_overlay(const FurFrame& frame, DrawTimes& times, const Pause& pause) {
  try {
    const std::vector<glm::vec3> field = models_.at(frame.model)->field_of(frame);
    const Result<FloatImage> drawn =
        draw_full_frame(scaled(frame), {RasterOutput::field, field, nullptr, Growth::only_drawn}, times, pause);
    if (!drawn) return drawn.status();
    const DrawClock clock(times);
    const FloatImage values = resized_light(*drawn, frame.width, frame.height, threads_);
    std::vector<glm::vec3> seen(values.rgba.size() / 4);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const float* value = &values.rgba[4 * i];
      const float share = std::min(value[2], 1.0f);
      if (share > 1e-3f) seen[i] = {value[0] / value[2], value[1] / value[2], share};
    }
    return field_picture(frame, seen, threads_);
  } catch (const std::bad_alloc&) {
    return no_memory_for_frame();
  }
}

TileMask RasterRenderer::changed_tiles(const FurFrame& frame, const ShownFrame& shown) {
  const Wanted wanted{RasterOutput::light};
  return changed_since(scene_of(grown(frame, wanted), frame, wanted), shown.changes, threads_);
}

template <class Picture, class Finish>
Result<Picture> RasterRenderer::draw_finished(const FurFrame& frame, int format, DrawTimes& times, const Pause& pause,
                                              const Finish& finish) {
  const FurFrame drawn = scaled(frame);
  CachedView view = views_.take(frame, format);
  std::optional<ShownFrame> shown = std::exchange(view.shown, {});
  Wanted wanted{RasterOutput::light, {}, nullptr, Growth::only_drawn, draws_on_gpu(drawn, Growth::only_drawn, times)};
  if (wanted.by_gpu) shown.reset();  // drawing all takes less time than finding what has changed
  if (!shown) view.light = empty_picture<FloatImage>(drawn.width, drawn.height);
  Area area = full_area(drawn);
  std::optional<TileMask> tiles;
  if (shown) {
    const DrawClock clock(times);
    tiles = changed_tiles(drawn, *shown);
    const PixelBox box = tiles->bounds();
    area = common_area(area, {box.left, box.top, box.right - box.left, box.bottom - box.top});
  }
  wanted.tiles = tiles ? &*tiles : nullptr;
  if (area.pixels() > 0)
    if (Status done = draw_area(drawn, area, wanted, times, pause, view.light); !done.ok()) return done;
  const DrawClock clock(times);
  RasterFur& raster_fur = grown(drawn, wanted);
  const bool ground = frame.ground && area.pixels() > 0;  // its shadow may change anywhere
  view.shown = {frame, shown && !ground ? shown->format : 0, raster_fur.raster->version()};
  FloatImage light;
  const bool darkens = frame.ground && !wanted.by_gpu;
  if (darkens) light = view.light, darken(drawn, raster_fur, {RasterOutput::light}, light);
  Picture picture = finish(view, darkens ? light : view.light, area);
  const double pixels = tiles ? std::min(area.pixels(), double{tile_pixels} * tiles->count()) : area.pixels();
  times.counters.redrawn = pixels / static_cast<double>(view.pixels());
  if (!wanted.by_gpu) views_.keep(std::move(view));
  return picture;
}

Result<std::optional<Image>> RasterRenderer::draw_on_gpu(const FurFrame& frame, DrawTimes& times) {
  const FurFrame drawn = scaled(frame);
  if (!draws_on_gpu(drawn, Growth::only_drawn, times)) return std::optional<Image>();
  const DrawClock clock(times);
  const Wanted wanted{RasterOutput::light, {}, nullptr, Growth::only_drawn, true};
  const RasterScene scene = scene_of(grown(drawn, wanted), drawn, wanted);
  Result<std::optional<Image>> picture = gpu_->draw_picture(scene, encoding_of(frame, 255));
  if (!picture && cpu_takes_over(picture.status())) return std::optional<Image>();
  times.counters.redrawn = 1;
  return picture;
}

Result<Image> RasterRenderer::draw(const FurFrame& frame, const FloatImage* overlay, DrawTimes& times,
                                   const Pause& pause) {
  try {
    if (!overlay && !frame.crop) {
      Result<std::optional<Image>> picture = draw_on_gpu(frame, times);
      if (!picture) return picture.status();
      if (*picture) return std::move(**picture);
    }
    return draw_finished<Image>(frame, cached_format(frame), times, pause,
                                [&](CachedView& view, const FloatImage& light, const Area& area) {
                                  return finish_view(frame, {light, overlay, threads_}, area, view);
                                });
  } catch (const std::bad_alloc&) {
    views_.clear();
    return no_memory_for_frame();
  }
}

Result<Image16> RasterRenderer::draw_deep(const FurFrame& frame, const FloatImage* overlay, DrawTimes& times,
                                          const Pause& pause) {
  try {
    return draw_finished<Image16>(frame, 0, times, pause, [&](CachedView&, const FloatImage& light, const Area&) {
      return finish_picture_deep(frame, {light, overlay, threads_});
    });
  } catch (const std::bad_alloc&) {
    views_.clear();
    return no_memory_for_frame();
  }
}

}  // namespace pelage
