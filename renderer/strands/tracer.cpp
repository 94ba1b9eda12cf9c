#include "renderer/strands/tracer.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <optional>
#include <span>

#include "base/stopwatch.h"
#include "renderer/coat/strand_tile.h"
#include "renderer/strands/film.h"
#include "renderer/strands/paths.h"
#include "renderer/strands/trace_scene.h"

namespace pelage {

namespace {

constexpr double min_width = 0.2;    // pixels; if strands are thinner in the picture, fewer and wider ones are drawn
constexpr double widest = 1.0 / 60;  // share of the fur's length; limits widening, up to a factor of 2 by rounding
constexpr double widest_allowed = 0.05;      // sizes; limit on the width of widened strands
constexpr std::size_t backplate_images = 5;  // images of a Backplate
constexpr int judged_passes = 8;             // passes before low noise may finish a tile
constexpr std::size_t film_part = 2;         // a film may take 1 / film_part of the memory

/// Returns the mean length over vertices with fur, sizes; 0 if there are none.
double mean_length(std::span<const float> lengths) {
  double sum = 0;
  std::size_t furred = 0;
  for (const float length : lengths) {
    if (length > 0) sum += static_cast<double>(length), ++furred;
  }
  return furred > 0 ? sum / static_cast<double>(furred) : 0;
}

/// Returns the mean fur length of the coat with the shortest fur, sizes; 0 if all are bald.
double shortest_fur(EachCoat<FurFields> fields) {
  double shortest = 0;
  for (const FurFields& of_coat : fields) {
    const double length = mean_length(of_coat.length);
    if (length > 0 && (shortest == 0 || length < shortest)) shortest = length;
  }
  return shortest;
}

/// Reduces the share of strands for a view and widens those that are left. The share is a power of 1/2, so that camera
/// steps seldom change it. The width is bounded, because wide strands stick out of short fur into the light: widened to
/// a third of the fur's height they make it a tenth too bright, and a small animal larger than it is. So from a certain
/// distance on the share stays the same.
void thin_out(const FurFrame& frame, double expected, double fur_length, std::vector<GrowRecipe>& recipes) {
  const double nearest = std::max(glm::length(glm::dvec3(frame.camera.position)) - 0.5, 0.0);
  const double pixel = 2 * double{frame.camera.tan_half_fov} / frame.height * nearest;
  double width = 1e-6;
  for (const GrowRecipe& recipe : recipes) width = std::max({width, recipe.coat.width_root, recipe.coat.width_tip});
  const double seen = width / std::clamp(min_width * pixel, 1e-9, std::max(widest * fur_length, 1e-9));
  const double allowed = expected > 0 ? frame.knobs.trace.strands / expected : 1;
  const double share = std::exp2(std::floor(std::log2(std::min({seen, allowed, 1.0}))));
  for (GrowRecipe& recipe : recipes)
    recipe.share = share, recipe.widening = std::clamp(1 / share, 1.0, std::max(widest_allowed / width, 1.0));
}

/// Returns the bytes of a backplate and of the resulting AOVs.
std::size_t pictures_bytes(int width, int height, std::span<const Aov> aovs) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * sizeof(glm::vec4) *
         (backplate_images + aovs.size());
}

}  // namespace

struct Tracer::Picture {
  TraceScene scene;
  Film film;
  std::vector<int> active;  // tiles of the film that still need samples
  bool blurred;             // strands move while the shutter is open
  std::size_t reserved;     // bytes for the picture, which strands may not take
  TraceReport report = {};

  bool trace_tile(const World& world, int tile, const GoOn& go_on);
  bool still_noisy(int tile) const;
  void judge();
};

struct Tracer::Impl {
  Impl(int threads, std::size_t bytes, bool yielding) : workers{threads, yielding}, memory(bytes), world(bytes) {}

  Result<World::Change> grow(const FurModel& model, EachCoat<FurFields> fields, const FurFrame& frame,
                             std::size_t picture_bytes, const GoOn& go_on);

  WorkThreads workers;
  std::size_t memory;
  World world;
  std::shared_ptr<const StrandShading> shading;
  std::shared_ptr<Picture> picture;  // null before the first
};

Tracer::Tracer(int threads, std::size_t memory, bool yielding)
    : impl_(std::make_unique<Impl>(threads, memory, yielding)) {}
Tracer::~Tracer() = default;

Status Tracer::admit(int width, int height, std::span<const Aov> aovs, bool filter) const {
  const std::size_t film = Film::bytes(width, height, aovs, filter), pictures = pictures_bytes(width, height, aovs);
  if (film <= impl_->memory / film_part && film + pictures <= impl_->memory) return {};
  return failure(Code::too_large, "The picture needs more memory than tracing may take.", "/width",
                 "fewer pixels, or fewer AOVs");
}

/// Grows strands within the memory that the picture leaves free.
Result<World::Change> Tracer::Impl::grow(const FurModel& model, EachCoat<FurFields> fields, const FurFrame& frame,
                                         std::size_t picture_bytes, const GoOn& go_on) {
  world.set_memory(memory - picture_bytes);
  const double area = fur_area(model);
  std::vector<GrowRecipe> recipes = recipes_of(frame, model.has_colours, area);
  double expected = 0;
  for (const GrowRecipe& recipe : recipes) expected += expected_strands(area, recipe.coat);
  thin_out(frame, expected, shortest_fur(fields), recipes);
  return world.update(model, fields, frame, recipes, workers, go_on);
}

Status Tracer::begin(const FurModel& model, EachCoat<FurFields> fields, const FurFrame& frame, Backplate base,
                     std::span<const Aov> aovs, const GoOn& go_on) {
  Impl& tracer = *impl_;
  const bool filter = frame.knobs.trace.filter;
  tracer.picture = nullptr;
  if (Status refused = admit(frame.width, frame.height, aovs, filter); !refused.ok()) return refused;
  const std::size_t reserved =
      pictures_bytes(frame.width, frame.height, aovs) + Film::bytes(frame.width, frame.height, aovs, filter);
  const Stopwatch passed;
  const Result<World::Change> change = tracer.grow(model, fields, frame, reserved, go_on);
  if (!change) return change.status();
  if (!tracer.shading || !tracer.shading->fits(frame)) tracer.shading = std::make_shared<const StrandShading>(frame);
  Film film(frame.width, frame.height, aovs, filter, frame.crop);
  std::vector<int> active(film.tiles().begin(), film.tiles().end());
  tracer.picture =
      std::make_shared<Picture>(Picture{TraceScene(frame, std::move(base), tracer.shading), std::move(film),
                                        std::move(active), !fields.front().closing.empty(), reserved});
  tracer.picture->report.strands = change->strands;
  tracer.picture->report.grow_ms = passed.milliseconds();
  return {};
}

std::shared_ptr<Tracer::Picture> Tracer::suspend() { return std::move(impl_->picture); }

std::size_t Tracer::picture_bytes() const {
  const Picture& picture = *impl_->picture;
  return picture.film.bytes() + picture.scene.backplate_bytes();
}

Status Tracer::resume(const FurModel& model, EachCoat<FurFields> fields, std::shared_ptr<Picture> picture,
                      const GoOn& go_on) {
  Impl& tracer = *impl_;
  const FurFrame& frame = picture->scene.frame();
  const Result<World::Change> change = tracer.grow(model, fields, frame, picture->reserved, go_on);
  if (!change) return change.status();
  tracer.picture = std::move(picture);
  return {};
}

bool Tracer::Picture::trace_tile(const World& world, int tile, const GoOn& go_on) {
  if (!go_on()) return false;
  const Tracing& trace = scene.frame().knobs.trace;
  const int left = tile % film.tiles_across() * Film::tile, top = tile / film.tiles_across() * Film::tile;
  for (int y = top; y < std::min(top + Film::tile, film.height()); ++y) {
    for (int x = left; x < std::min(left + Film::tile, film.width()); ++x) {
      const auto pixel = static_cast<std::uint32_t>(y * film.width() + x);
      Sampler sampler(pixel, static_cast<std::uint32_t>(film.samples(x, y)), trace.seed);
      const glm::vec2 position = glm::vec2(x, y) + sampler.next2();
      const float time = blurred ? sampler.next() : 0;
      const bool paths = trace.transport == Transport::paths;
      film.add(x, y,
               paths ? path_sample(scene, world, position, time, sampler)
                     : transmitted_sample(scene, world, position, time, sampler));
    }
  }
  return true;
}

/// Returns whether a tile still needs samples: after judged_passes, only tiles whose noise is not below the limit do.
bool Tracer::Picture::still_noisy(int tile) const {
  const double limit = scene.frame().knobs.trace.noise;
  return limit == 0 || report.passes < judged_passes || film.noise(tile, scene.frame().exposure) >= limit;
}

void Tracer::Picture::judge() {
  const Tracing& trace = scene.frame().knobs.trace;
  report.samples = film.mean_samples();
  report.noise = film.noise(scene.frame().exposure);
  active.clear();
  for (const int tile : film.tiles()) {
    if (still_noisy(tile)) active.push_back(tile);
  }
  if (active.empty())
    report.end = TraceEnd::noise;
  else if (report.passes >= trace.passes)
    report.end = TraceEnd::passes;
  else if (trace.seconds > 0 && report.grow_ms + report.trace_ms >= 1e3 * trace.seconds)
    report.end = TraceEnd::seconds;
}

Status Tracer::add_pass(const GoOn& go_on) {
  Picture& picture = *impl_->picture;
  if (picture.report.end != TraceEnd::none) return {};
  const Stopwatch passed;
  const std::vector<int>& tiles = picture.active;
  const bool completed = for_each_until_false(
      impl_->workers, tiles.size(), [&](std::size_t i) { return picture.trace_tile(impl_->world, tiles[i], go_on); });
  picture.report.trace_ms += passed.milliseconds();
  if (!completed) return cancelled_status();
  ++picture.report.passes;
  picture.judge();
  return {};
}

TraceReport Tracer::report() const { return impl_->picture->report; }

FloatImage Tracer::aov(Aov aov) const {
  return impl_->picture->film.aov(aov, impl_->picture->scene.frame().knobs.trace.filter);
}

}  // namespace pelage
