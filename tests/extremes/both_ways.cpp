#include "tests/extremes/both_ways.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "server/frames/fur_view.h"
#include "server/frames/moved_fur.h"

namespace pelage::testing {

namespace {

constexpr std::array all_aovs{Aov::beauty,  Aov::alpha,  Aov::depth,  Aov::position, Aov::normal,
                              Aov::tangent, Aov::albedo, Aov::direct, Aov::shadow,   Aov::shell_count};
constexpr std::array<const char*, 10> aov_names{"beauty",  "alpha",  "depth",  "position", "normal",
                                                "tangent", "albedo", "direct", "shadow",   "shell_count"};
constexpr float above_one = 1.001f;  // sums of half floats

bool is_light(Aov aov) { return aov == Aov::beauty || aov == Aov::direct || aov == Aov::albedo; }

bool fine(Aov aov, std::size_t channel, float value) {
  if (!std::isfinite(value)) return false;
  if (is_light(aov) && value < 0) return false;
  if (aov == Aov::depth) return channel != 0 || value >= 0;
  if (channel == 3) return value >= 0 && value <= above_one;
  return true;
}

FrameRequest sorted_with_all(FrameRequest request) {
  Knobs& knobs = request.knobs;
  knobs.order = FragmentOrder::sorted, knobs.shell_policy = ShellPolicy::uniform;
  knobs.guard_hairs = std::max(knobs.guard_hairs, 200);
  knobs.scale = 1;
  return request;
}

/// A difference is of two revisions, which nothing here has.
FrameRequest marchable(FrameRequest request) {
  if (request.overlay == Overlay::difference) request.overlay = Overlay::none, request.overlay_from.reset();
  return request;
}

FrameRequest traced(FrameRequest request, Transport transport) {
  Knobs& knobs = request.knobs;
  const int guard_hairs = knobs.guard_hairs, eye_steps = knobs.eye_steps;
  knobs = {};
  knobs.method = Method::strands, knobs.guard_hairs = guard_hairs, knobs.eye_steps = eye_steps;
  knobs.trace.passes = 1, knobs.trace.strands = 2000, knobs.trace.transport = transport;
  return request;
}

bool always() { return true; }

}  // namespace

FrameRequest rasterized(FrameRequest request) {
  Knobs knobs{.scale = std::min(request.knobs.scale, 1.0), .eye_steps = request.knobs.eye_steps};
  knobs.method = Method::raster, knobs.guard_hairs = request.knobs.guard_hairs;
  request.knobs = knobs, request.overlay = Overlay::none, request.overlay_from.reset();
  return request;
}

std::string complaint_about(const std::vector<FloatImage>& aovs) {
  for (std::size_t l = 0; l < aovs.size(); ++l) {
    for (std::size_t i = 0; i < aovs[l].rgba.size(); ++i) {
      const float value = aovs[l].rgba[i];
      if (fine(all_aovs[l], i % 4, value)) continue;
      return std::string(aov_names[l]) + " of pixel " + std::to_string(i / 4) + ", channel " + std::to_string(i % 4) +
             ": " + std::to_string(value);
    }
  }
  return {};
}

namespace {

/// Null where nothing blows.
MovedDirection moved_of(const SceneView& view, const FrameRequest& request) {
  const std::optional<double> moment = moment_of(view, request);
  return moment ? moved_at(view, *moment) : nullptr;
}

}  // namespace

FurFrame BothWays::sync(Scene& scene, const FrameRequest& request) {
  std::optional<FurFrame> frame;
  scene.read_for_drawing([&](const SceneView& view, const std::vector<VertexRange>&) {
    const std::vector<VertexRange> all{{0, static_cast<std::uint32_t>(view.fields.size())}};
    sync_scene(renderer_, view, all, moved_of(view, request).get(), request.knobs.method == Method::raster);
    frame = make_frame(view, request);
  });
  renderer_.clear_view_cache();
  return *frame;
}

Result<Image> BothWays::show(Scene& scene, const FrameRequest& request) { return renderer_.draw(sync(scene, request)); }

Result<std::vector<FloatImage>> BothWays::draw(Scene& scene, const FrameRequest& request) {
  const FurFrame frame = sync(scene, request);
  if (Result<Image> shown = renderer_.draw(frame); !shown) return shown.status();
  return renderer_.draw_aovs(frame, all_aovs);
}

Result<std::vector<FloatImage>> BothWays::march(Scene& scene, const FrameRequest& request) {
  std::optional<FurFrame> frame;
  scene.read_for_drawing([&](const SceneView& view, const std::vector<VertexRange>&) {
    frame = make_frame(view, marchable(request));
    const std::vector<FurSkinRegion> skin = make_skin(view.settings.skin, view.model.surface.mesh());
    const ModelArrays arrays = make_arrays(view);
    marched_.forget_all();
    const MovedDirection moved = moved_of(view, request);
    marched_.add(make_model(view, arrays), make_fields(view, skin, {}, moved.get()));
  });
  if (Result<Image> shown = marched_.draw(*frame, nullptr, {}); !shown) return shown.status();
  return marched_.draw_aovs(*frame, all_aovs, nullptr, {});
}

Result<std::vector<FloatImage>> BothWays::trace(Scene& scene, const FrameRequest& request) {
  if (Status refused = tracer_.admit(request.width, request.height, all_aovs, true); !refused.ok()) return refused;
  Status status;
  scene.read_for_drawing([&](const SceneView& view, const std::vector<VertexRange>& dirty) {
    sync_scene(renderer_, view, dirty);
    const FurFrame frame = make_frame(view, request);
    Result<Backplate> base = renderer_.draw_backplate(frame);
    if (!base) {
      status = base.status();
      return;
    }
    const Mesh& mesh = view.model.surface.mesh();
    const std::vector<FurSkinRegion> skin = make_skin(view.settings.skin, mesh);
    const DirtyRange all{0, static_cast<std::uint32_t>(mesh.positions.size())};
    const ModelArrays arrays = make_arrays(view);
    const MovedDirection moved = moved_of(view, request);
    status = tracer_.begin(make_model(view, arrays), make_fields(view, skin, std::span(&all, 1), moved.get()), frame,
                           std::move(base).value(), all_aovs, always);
  });
  while (status.ok() && tracer_.report().end == TraceEnd::none) status = tracer_.add_pass(always);
  if (!status.ok()) return status;
  std::vector<FloatImage> images;
  for (const Aov aov : all_aovs) images.push_back(tracer_.aov(aov));
  return images;
}

Status BothWays::check(Result<std::vector<FloatImage>> images, const char* way, std::string& complaint) {
  if (!images) return images.status();
  ++pictures_;
  const std::string found = complaint_about(*images);
  if (!found.empty()) complaint += std::string(way) + ": " + found + "\n";
  return {};
}

Status BothWays::look_at(Scene& scene, const FrameRequest& request, std::string& complaint) {
  Status status = check(draw(scene, request), "shells", complaint);
  if (status.ok()) status = check(march(scene, request), "marched", complaint);
  if (status.ok()) status = check(draw(scene, sorted_with_all(request)), "sorted shells", complaint);
  if (status.ok()) status = check(draw(scene, rasterized(request)), "raster", complaint);
  if (status.ok()) status = check(trace(scene, traced(request, Transport::transmittance)), "strands", complaint);
  if (status.ok()) status = check(trace(scene, traced(request, Transport::paths)), "paths", complaint);
  return status;
}

}  // namespace pelage::testing
