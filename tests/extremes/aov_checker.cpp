#include "tests/extremes/aov_checker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "server/frames/fur_view.h"
#include "server/frames/shown_fur.h"

namespace pelage::testing {

namespace {

constexpr std::array all_aovs{Aov::beauty,    Aov::alpha,     Aov::depth,  Aov::position, Aov::normal,
                              Aov::tangent,   Aov::albedo,    Aov::direct, Aov::shadow,   Aov::sample_count,
                              Aov::objects_1, Aov::objects_2, Aov::strand, Aov::root};
constexpr std::array<const char*, all_aovs.size()> aov_names{
    "beauty", "alpha",  "depth",        "position",  "normal",    "tangent", "albedo",
    "direct", "shadow", "sample_count", "objects_1", "objects_2", "strand",  "root"};
constexpr std::span<const Aov> traced_aovs = std::span(all_aovs).first(all_aovs.size() - 2);  // all but strand and root
constexpr float above_one = 1.001f;                                                           // sums of half floats

bool is_light(Aov aov) { return aov == Aov::beauty || aov == Aov::direct || aov == Aov::albedo; }

bool fine(Aov aov, std::size_t channel, float value) {
  if (!std::isfinite(value)) return false;
  if (is_light(aov) && value < 0) return false;
  if (aov == Aov::depth) return channel != 0 || value >= 0;
  if (aov == Aov::strand) return value >= 0;
  if (channel == 3 || aov == Aov::objects_1 || aov == Aov::objects_2) return value >= 0 && value <= above_one;
  return true;
}

FrameRequest layered(FrameRequest request, FragmentOrder order) {
  request.knobs.method = Method::shells, request.knobs.shells.order = order;
  request.overlay = Overlay::none, request.overlay_from.reset();
  return request;
}

FrameRequest traced(FrameRequest request, Transport transport) {
  Knobs& knobs = request.knobs;
  knobs = {.method = Method::strands, .eye_steps = knobs.eye_steps};
  knobs.trace.passes = 1, knobs.trace.strands = 2000, knobs.trace.transport = transport;
  return request;
}

bool always() { return true; }

}  // namespace

FrameRequest rasterized(FrameRequest request) {
  request.knobs.method = Method::raster, request.knobs.scale = std::min(request.knobs.scale, 1.0);
  if (request.overlay == Overlay::difference) request.overlay = Overlay::none, request.overlay_from.reset();
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

/// Directions moved by the wind, or null without wind.
MovedDirection moved_of(const SceneView& view, const FrameRequest& request) {
  const std::optional<double> moment = moment_of(view, request);
  return moment ? moved_at(view, *moment) : nullptr;
}

}  // namespace

FurFrame AovChecker::sync(Scene& scene, const FrameRequest& request) {
  const SnapshotPtr now = scene.snapshot();
  const SceneView view = now->view();
  const std::vector<VertexRange> all = full_vertex_range(view.fields.size());
  sync_scene(renderer_, view, all, moved_of(view, request).get(), request.knobs.method == Method::shells);
  FurFrame frame = make_frame(view, request);
  frame.coat().count = std::min(frame.coat().count, max_count_);
  renderer_.clear_view_cache();
  return frame;
}

Result<Image> AovChecker::show(Scene& scene, const FrameRequest& request) {
  return renderer_.draw(sync(scene, request));
}

Result<std::vector<FloatImage>> AovChecker::draw(Scene& scene, const FrameRequest& request) {
  const FurFrame frame = sync(scene, request);
  if (Result<Image> shown = renderer_.draw(frame); !shown) return shown.status();
  const std::size_t aovs = request.knobs.method == Method::shells ? 2 : all_aovs.size();  // only beauty and alpha
  return renderer_.draw_aovs(frame, std::span(all_aovs).first(aovs));
}

Result<std::vector<FloatImage>> AovChecker::trace(Scene& scene, const FrameRequest& request) {
  if (Status refused = tracer_.admit(request.width, request.height, traced_aovs, true); !refused.ok()) return refused;
  const SnapshotPtr now = scene.snapshot();
  const SceneView view = now->view();
  const Mesh& mesh = view.model.surface.mesh();
  sync_scene(renderer_, view, full_vertex_range(mesh.positions.size()));
  const FurFrame frame = make_frame(view, request);
  Result<Backplate> base = renderer_.draw_backplate(frame);
  if (!base) return base.status();
  const std::vector<FurSkinRegion> skin = make_skin(view.settings.skin, mesh);
  const DirtyRange all{0, static_cast<std::uint32_t>(mesh.positions.size())};
  const ModelArrays arrays = make_arrays(view);
  const MovedDirection moved = moved_of(view, request);
  Status status = tracer_.begin(make_model(view, arrays), make_fields(view, skin, std::span(&all, 1), moved.get()),
                                frame, std::move(base).value(), traced_aovs, always);
  while (status.ok() && tracer_.report().end == TraceEnd::none) status = tracer_.add_pass(always);
  if (!status.ok()) return status;
  std::vector<FloatImage> images;
  for (const Aov aov : traced_aovs) images.push_back(tracer_.aov(aov));
  return images;
}

Status AovChecker::check(Result<std::vector<FloatImage>> images, const char* method, std::string& complaint) {
  if (!images) return images.status();
  ++pictures_;
  const std::string found = complaint_about(*images);
  if (!found.empty()) complaint += std::string(method) + ": " + found + "\n";
  return {};
}

Status AovChecker::look_at(Scene& scene, const FrameRequest& request, std::string& complaint) {
  Status status = check(draw(scene, rasterized(request)), "raster", complaint);
  for (const FragmentOrder order : {FragmentOrder::four_pass, FragmentOrder::sorted})
    if (status.ok()) status = check(draw(scene, layered(request, order)), "shells", complaint);
  if (status.ok()) status = check(trace(scene, traced(request, Transport::transmittance)), "strands", complaint);
  if (status.ok()) status = check(trace(scene, traced(request, Transport::paths)), "paths", complaint);
  return status;
}

}  // namespace pelage::testing
