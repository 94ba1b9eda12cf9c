#include "renderer/frame/raster_renderer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <new>
#include <optional>
#include <utility>

#include "renderer/finish/resize.h"
#include "renderer/frame/areas.h"
#include "renderer/frame/draw_clock.h"
#include "renderer/raster/model_copy.h"
#include "renderer/raster/raster.h"
#include "renderer/strands/grown_fur.h"

namespace pelage {

namespace {

constexpr double max_strands = 2e6;            // that grow of a coat; fewer are wider
constexpr std::size_t max_bytes = 512u << 20;  // that is grown of all models together, but for the drawn one

/// `whole_coats`: how many coats of one strand on a tile of 1 the model's skin has room for.
GrowRecipe recipe_of(const FurFrame& frame, bool has_colours, double whole_coats) {
  GrowRecipe recipe{.coat = frame.coat, .model_colours = takes_model_colours(frame.look, has_colours)};
  const double expected = whole_coats * frame.coat.count / (frame.coat.tile * frame.coat.tile);
  recipe.guard_share = expected > 0 ? std::min(frame.knobs.guard_hairs / expected, 1.0) : 0;
  recipe.share = std::min(max_strands / std::max(expected, 1.0), 1.0);
  recipe.widening = 1 / recipe.share;
  return recipe;
}

double whole_coats_of(const FurModel& model) {
  Coat coat;
  coat.count = 1, coat.tile = 1;
  return expected_strands(model, coat);
}

RasterQuality quality_of(const Knobs& knobs) {
  constexpr float seen_depth = 6, soft_width = 2;  // docs/notes/2026-11-27-strand-raster.md
  return {knobs.raster.strands, knobs.raster.light_of, seen_depth, soft_width};
}

/// The frame as it is drawn, before its light is resized.
FurFrame scaled(const FurFrame& frame) {
  const auto pixels = [&](int asked) { return std::max(1, static_cast<int>(std::lround(asked * frame.knobs.scale))); };
  FurFrame drawn = frame;
  drawn.width = pixels(frame.width), drawn.height = pixels(frame.height);
  const Area area = drawn_area(frame, {drawn.width, drawn.height});
  if (frame.crop) drawn.crop = Crop{area.left, area.top, area.width, area.height};
  return drawn;
}

RasterOutput output_of(Aov aov) {
  switch (aov) {
    case Aov::depth: return RasterOutput::depth;
    case Aov::position: return RasterOutput::distance;
    case Aov::normal: return RasterOutput::normal;
    case Aov::tangent: return RasterOutput::tangent;
    case Aov::albedo: return RasterOutput::albedo;
    case Aov::direct: return RasterOutput::direct;
    case Aov::shadow: return RasterOutput::shadow;
    case Aov::shell_count: return RasterOutput::count;
    default: return RasterOutput::light;
  }
}

/// Where a pixel's ray is at a distance along the view.
glm::vec3 place_at(const FurFrame& frame, int x, int y, float distance) {
  const FurCamera& camera = frame.camera;
  const float over = 2 * camera.tan_half_fov / static_cast<float>(frame.height);
  const glm::vec2 off = (glm::vec2(x, y) + 0.5f - 0.5f * glm::vec2(frame.width, frame.height)) * over;
  return camera.position + distance * (camera.forward + off.x * camera.right - off.y * camera.up);
}

/// What an AOV has of the mean of a pixel.
glm::vec4 ruled(const FurFrame& frame, Aov aov, glm::vec4 mean, int x, int y) {
  const float alpha = std::clamp(mean.a, 0.0f, 1.0f);
  const glm::vec3 rgb(mean);
  switch (aov) {
    case Aov::depth: return {mean.r, 0, 0, 1};
    case Aov::position: return {alpha > 0 ? place_at(frame, x, y, mean.r / mean.a) : glm::vec3(0), alpha};
    case Aov::normal:
    case Aov::tangent: return {glm::dot(rgb, rgb) > 1e-12f ? glm::normalize(rgb) : glm::vec3(0), alpha};
    case Aov::shadow: return {glm::vec3(mean.g > 0 ? std::clamp(mean.r / mean.g, 0.0f, 1.0f) : 1), alpha};
    default: return mean;
  }
}

/// One over the distance in the middle of each pixel: between surfaces there is nothing.
FloatImage picked(const FloatImage& drawn, int width, int height) {
  FloatImage picture;
  picture.width = width, picture.height = height;
  picture.rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const auto nearest = [](int at, int to, int from) { return std::min((2 * at + 1) * from / (2 * to), from - 1); };
  for (int y = 0; y < height; ++y) {
    const auto row = static_cast<std::size_t>(nearest(y, height, drawn.height)) * static_cast<std::size_t>(drawn.width);
    for (int x = 0; x < width; ++x) {
      const std::size_t from = row + static_cast<std::size_t>(nearest(x, width, drawn.width));
      std::copy_n(&drawn.rgba[4 * from], 4,
                  &picture.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                     static_cast<std::size_t>(x))]);
    }
  }
  return picture;
}

FloatImage aov_picture(const FurFrame& frame, Aov aov, const FloatImage& drawn, int threads) {
  FloatImage picture = aov == Aov::depth ? picked(drawn, frame.width, frame.height)
                                         : resized_light(drawn, frame.width, frame.height, threads);
  std::size_t at = 0;
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x, at += 4) {
      float* rgba = &picture.rgba[at];
      const glm::vec4 value = ruled(frame, aov, {rgba[0], rgba[1], rgba[2], rgba[3]}, x, y);
      for (int k = 0; k < 4; ++k) rgba[k] = value[k];
    }
  }
  return picture;
}

}  // namespace

/// What is kept of a model: its fur as it stood when it was drawn last.
struct RasterRenderer::Model {
  Model(const FurModel& model, const FurFields& fields) : copy(model, fields), whole_coats(whole_coats_of(model)) {}

  ModelCopy copy;
  double whole_coats;
  std::uint64_t used = 0;
  GrownFur fur;
  std::unique_ptr<Raster> raster;  // null where nothing is grown
  // What the fur was grown of:
  std::optional<GrowRecipe> recipe;
  std::uint64_t changes = 0;
  std::vector<FurCurves> curves;

  void grow(const FurFrame& frame, int threads) {
    const GrowRecipe wanted = recipe_of(frame, copy.model().has_colours, whole_coats);
    if (recipe == wanted && changes == copy.changes() && curves == frame.curves) return;
    if (!raster) raster = std::make_unique<Raster>(threads);
    fur.update(copy.model(), copy.fields(), wanted, threads, frame.curves);
    recipe = wanted, changes = copy.changes(), curves = frame.curves;
  }
  void drop() { fur = GrownFur(), raster.reset(), recipe.reset(); }
  /// That a drop would free.
  std::size_t grown_bytes() const { return raster ? fur.bytes() + raster->bytes() : 0; }
};

RasterRenderer::RasterRenderer(int threads) : threads_(threads) {}
RasterRenderer::~RasterRenderer() = default;

std::size_t RasterRenderer::add(const FurModel& model, const FurFields& fields) {
  assert(!has(model.id));
  return models_.try_emplace(model.id, std::make_unique<Model>(model, fields)).first->second->copy.bytes();
}

std::size_t RasterRenderer::update(std::uint64_t model, const FurFields& fields) {
  return models_.at(model)->copy.update(fields);
}

void RasterRenderer::forget(std::uint64_t original) {
  std::erase_if(models_, [&](const auto& entry) { return entry.second->copy.original() == original; });
}

void RasterRenderer::forget_all() { models_.clear(); }

std::size_t RasterRenderer::bytes_of(std::uint64_t original) const {
  std::size_t bytes = 0;
  for (const auto& [id, model] : models_)
    if (model->copy.original() == original) bytes += model->copy.bytes() + model->grown_bytes();
  return bytes;
}

RasterRenderer::Model& RasterRenderer::grown(const FurFrame& frame) {
  Model& own = *models_.at(frame.model);
  own.used = ++uses_;
  own.grow(frame, threads_);
  std::vector<Model*> others;
  std::size_t bytes = 0;
  for (const auto& [id, model] : models_)
    if (model.get() != &own && model->recipe) others.push_back(model.get()), bytes += model->grown_bytes();
  std::sort(others.begin(), others.end(), [](const Model* a, const Model* b) { return a->used < b->used; });
  for (auto oldest = others.begin(); oldest != others.end() && bytes > max_bytes; ++oldest)
    bytes -= (*oldest)->grown_bytes(), (*oldest)->drop();
  return own;
}

Result<FloatImage> RasterRenderer::draw_shown(const FurFrame& frame, RasterOutput shown, DrawTimes& times,
                                              const Pause& pause) {
  FloatImage picture;
  picture.width = frame.width, picture.height = frame.height;
  picture.rgba.resize(4 * static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height));
  RasterTimes spent;
  RasterCounts counts;
  const std::vector<PixelBox> boxes = Raster::boxes_of(frame);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (i > 0 && pause && !pause()) return drawing_given_up();
    const DrawClock clock(times);
    Model& model = grown(frame);  // in the pause others may have drawn it in another coat
    const RasterScene scene =
        model.raster->scene_of(model.copy.model(), model.fur, frame, quality_of(frame.knobs), shown);
    model.raster->draw_box(scene, boxes[i], picture, spent, counts);
  }
  return picture;
}

Result<std::vector<FloatImage>> RasterRenderer::draw(const FurFrame& frame, std::span<const Aov> aovs, DrawTimes& times,
                                                     const Pause& pause) {
  const FurFrame drawn = scaled(frame);
  std::vector<FloatImage> pictures;
  try {
    std::optional<FloatImage> light;
    for (const Aov aov : aovs) {
      const bool known = output_of(aov) == RasterOutput::light && light;
      Result<FloatImage> image = known ? *light : draw_shown(drawn, output_of(aov), times, pause);
      if (!image) return image.status();
      const DrawClock clock(times);
      pictures.push_back(aov_picture(frame, aov, *image, threads_));
      if (output_of(aov) == RasterOutput::light) light = std::move(*image);
    }
  } catch (const std::bad_alloc&) {
    return no_memory_for_frame();
  }
  times.counters.redrawn = 1;
  return pictures;
}

}  // namespace pelage
