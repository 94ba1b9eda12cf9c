#include "renderer/strands/tracer.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <optional>
#include <span>

#include "protocol/base/stopwatch.h"
#include "renderer/strands/film.h"
#include "renderer/strands/paths.h"
#include "renderer/strands/trace_scene.h"

namespace pelage {

namespace {

constexpr double min_width = 0.2;    // of a strand in the picture, pixels; thinner ones are thinned out and widened
constexpr double widest = 1.0 / 60;  // of the fur's length that strands are widened to because they are thin, or twice
constexpr double widest_allowed = 0.05;      // sizes that they are widened to because they would be too many
constexpr std::size_t backplate_images = 5;  // of a Backplate
constexpr int judged_passes = 8;             // before them no part of the picture is left for its little noise
constexpr std::size_t film_part = 2;         // a film takes at most one over this of the memory

/// Of the fur where there is any, sizes.
double mean_length(std::span<const float> lengths) {
  double sum = 0;
  std::size_t furred = 0;
  for (const float length : lengths) {
    if (length > 0) sum += static_cast<double>(length), ++furred;
  }
  return furred > 0 ? sum / static_cast<double>(furred) : 0;
}

/// Thins strands out for a view and widens what is left. The share is a power of 1/2, so that a step of the camera
/// seldom changes it. Wide strands stand out of short fur into the light: widened to a third of its height they make it
/// a tenth too bright, and a small animal larger than it is. So from afar no more are left out.
void thin_out(const FurFrame& frame, double expected, double fur_length, GrowRecipe& recipe) {
  const double nearest = std::max(glm::length(glm::dvec3(frame.camera.position)) - 0.5, 0.0);
  const double pixel = 2 * double{frame.camera.tan_half_fov} / frame.height * nearest;
  const double width = std::max({frame.coat.width_root, frame.coat.width_tip, 1e-6});
  const double seen = width / std::clamp(min_width * pixel, 1e-9, std::max(widest * fur_length, 1e-9));
  const double allowed = expected > 0 ? frame.knobs.trace.strands / expected : 1;
  recipe.share = std::exp2(std::floor(std::log2(std::min({seen, allowed, 1.0}))));
  recipe.widening = std::clamp(1 / recipe.share, 1.0, std::max(widest_allowed / width, 1.0));
}

/// Of a backplate and of the AOVs that are made in the end.
std::size_t picture_bytes(int width, int height, std::span<const Aov> aovs) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * sizeof(glm::vec4) *
         (backplate_images + aovs.size());
}

}  // namespace

struct Tracer::Impl {
  Impl(int threads, std::size_t bytes, bool yielding) : workers{threads, yielding}, memory(bytes), world(bytes) {}

  bool trace_tile(int tile, const GoOn& go_on);
  bool still_noisy(int tile) const;
  void judge();

  Workers workers;
  std::size_t memory;
  World world;
  std::optional<StrandShading> shading;
  std::optional<TraceScene> scene;
  std::optional<Film> film;
  std::vector<int> active;  // tiles of the film that still need samples
  bool blurred = false;     // strands move while the shutter is open
  TraceReport report;
};

Tracer::Tracer(int threads, std::size_t memory, bool yielding)
    : impl_(std::make_unique<Impl>(threads, memory, yielding)) {}
Tracer::~Tracer() = default;

Status Tracer::admit(int width, int height, std::span<const Aov> aovs, bool filter) const {
  const std::size_t film = Film::bytes(width, height, aovs, filter), pictures = picture_bytes(width, height, aovs);
  if (film <= impl_->memory / film_part && film + pictures <= impl_->memory) return {};
  return failure(Code::too_large, "The picture needs more memory than tracing may take.", "/width",
                 "fewer pixels, or fewer AOVs");
}

Status Tracer::begin(const FurModel& model, const FurFields& fields, const FurFrame& frame, Backplate base,
                     std::span<const Aov> aovs, const GoOn& go_on) {
  Impl& tracer = *impl_;
  tracer.film.reset(), tracer.scene.reset(), tracer.report = {};
  if (Status refused = admit(frame.width, frame.height, aovs, frame.knobs.trace.filter); !refused.ok()) return refused;
  tracer.world.set_memory(tracer.memory - picture_bytes(frame.width, frame.height, aovs) -
                          Film::bytes(frame.width, frame.height, aovs, frame.knobs.trace.filter));
  const Stopwatch passed;
  GrowRecipe recipe{.coat = frame.coat, .model_colours = takes_model_colours(frame.look, model.has_colours)};
  const double expected = expected_strands(model, frame.coat);
  recipe.guard_share = expected > 0 ? std::min(frame.knobs.guard_hairs / expected, 1.0) : 0;
  thin_out(frame, expected, mean_length(fields.length), recipe);
  const Result<World::Change> change = tracer.world.update(model, fields, frame, recipe, tracer.workers, go_on);
  if (!change) return change.status();
  if (!tracer.shading || !tracer.shading->fits(frame)) tracer.shading.emplace(frame);
  tracer.scene.emplace(frame, std::move(base), *tracer.shading);
  tracer.film.emplace(frame.width, frame.height, aovs, frame.knobs.trace.filter, frame.crop);
  tracer.active.assign(tracer.film->tiles().begin(), tracer.film->tiles().end());
  tracer.blurred = !fields.closing.empty();
  tracer.report.strands = change->strands;
  tracer.report.grow_ms = passed.milliseconds();
  return {};
}

bool Tracer::Impl::trace_tile(int tile, const GoOn& go_on) {
  if (!go_on()) return false;
  const Tracing& trace = scene->frame().knobs.trace;
  const int left = tile % film->tiles_across() * Film::tile, top = tile / film->tiles_across() * Film::tile;
  for (int y = top; y < std::min(top + Film::tile, film->height()); ++y) {
    for (int x = left; x < std::min(left + Film::tile, film->width()); ++x) {
      const auto pixel = static_cast<std::uint32_t>(y * film->width() + x);
      Sampler sampler(pixel, static_cast<std::uint32_t>(film->samples(x, y)), trace.seed);
      const glm::vec2 place = glm::vec2(x, y) + sampler.next2();
      const float time = blurred ? sampler.next() : 0;
      const bool paths = trace.transport == Transport::paths;
      film->add(x, y,
                paths ? path_sample(*scene, world, place, time, sampler)
                      : transmitted_sample(*scene, world, place, time, sampler));
    }
  }
  return true;
}

/// Parts with little noise are left alone, but for those that no ray hit anything in: those are cheap.
bool Tracer::Impl::still_noisy(int tile) const {
  const double limit = scene->frame().knobs.trace.noise;
  return limit == 0 || report.passes < judged_passes || film->noise(tile, scene->frame().exposure) >= limit;
}

void Tracer::Impl::judge() {
  const Tracing& trace = scene->frame().knobs.trace;
  report.samples = film->mean_samples();
  report.noise = film->noise(scene->frame().exposure);
  active.clear();
  for (const int tile : film->tiles()) {
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
  Impl& tracer = *impl_;
  if (tracer.report.end != TraceEnd::none) return {};
  const Stopwatch passed;
  const std::vector<int>& tiles = tracer.active;
  const bool whole =
      for_each_piece(tracer.workers, tiles.size(), [&](std::size_t i) { return tracer.trace_tile(tiles[i], go_on); });
  tracer.report.trace_ms += passed.milliseconds();
  if (!whole) return not_wanted();
  ++tracer.report.passes;
  tracer.judge();
  return {};
}

TraceReport Tracer::report() const { return impl_->report; }

FloatImage Tracer::aov(Aov aov) const { return impl_->film->aov(aov, impl_->scene->frame().knobs.trace.filter); }

}  // namespace pelage
