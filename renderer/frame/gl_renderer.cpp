#include "renderer/frame/gl_renderer.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include "renderer/coat/strand_tile.h"
#include "renderer/frame/parts.h"
#include "renderer/gl/sync.h"
#include "renderer/passes/draw/draw.h"
#include "renderer/pattern/pattern.h"
#include "renderer/shaders/constants.h"
#include "renderer/upload/blocks.h"

namespace pelage {

namespace {

constexpr std::size_t max_cached_coats = 3;  // 90 MB each
constexpr std::int64_t max_kept_pixels = 2048 * 2048;

bool has_tufts(const Coat& coat) { return coat.tufts.gather > 0; }

/// The #define lines of what a frame uses: what it does not use is not even compiled.
std::string variant_of(const FurFrame& frame, const ModelBuffers& model) {
  return std::string(ShadowMaps::wanted(frame) ? "#define SHADOW_MAPS\n" : "") +
         (ShadowMaps::of_curves(frame) ? "#define CURVE_SHADOWS\n" : "") + light_of(frame, model.has_colours()) +
         shape_of(frame.coat, model) +
         (max_lod(frame.knobs.shells, frame.knobs.shell_policy) > 0 ? "#define SHELL_LOD\n" : "") +
         "#define SHADING_MODEL " + std::to_string(static_cast<int>(frame.look.shading)) + "\n";
}

int scaled(int pixels, double scale) { return std::max(1, static_cast<int>(std::lround(pixels * scale))); }

}  // namespace

std::string light_of(const FurFrame& frame, bool model_has_colours) {
  const Environment& around = frame.environment;
  const bool constant = !around.harmonics && around.sky == glm::vec3(1) && around.horizon == around.sky &&
                        around.ground == around.sky && around.intensity == 1;
  const bool far = std::all_of(frame.lights.begin(), frame.lights.end(),
                               [](const FurLight& light) { return light.kind == LightKind::directional; });
  return std::string(constant ? "" : "#define ENVIRONMENT\n") + (far ? "#define FAR_LIGHTS\n" : "") +
         (takes_model_colours(frame.look, model_has_colours) ? "" : "#define RAMP_COLOURS\n") + "#define LIGHTS " +
         std::to_string(frame.lights.size()) + "\n";
}

std::string shape_of(const Coat& coat, const ModelBuffers& model) {
  return std::string(has_pattern(coat) ? "#define PATTERN\n" : "") + (has_tufts(coat) ? "#define TUFTS\n" : "") +
         model.paint().defines();
}

Result<std::unique_ptr<GlRenderer>> GlRenderer::create(const Gl& gl, std::size_t sorted_bytes, CoatSource coats) {
  std::unique_ptr<GlRenderer> renderer(new GlRenderer(gl, sorted_bytes, std::move(coats)));
  if (const Status status = renderer->programs(); !status.ok()) return status;
  return renderer;
}

GlRenderer::GlRenderer(const Gl& gl, std::size_t sorted_bytes, CoatSource coats)
    : gl_(gl),
      coat_source_(std::move(coats)),
      fur_(gl),
      guard_hairs_(gl),
      shadows_(gl),
      ground_(gl),
      eyes_(gl),
      aovs_(gl),
      resolve_(gl),
      sorted_(gl, sorted_bytes),
      pattern_(gl),
      tufts_(gl),
      paint_(gl),
      scattering_(gl),
      frame_block_(gl),
      skin_block_(gl),
      fragments_(gl) {}

Status GlRenderer::programs() const {
  const std::string log = fur_.failure() + guard_hairs_.failure() + curves_.failure() + shadows_.failure() +
                          ground_.failure() + eyes_.failure() + aovs_.failure() + resolve_.failure() +
                          sorted_.failure();
  return log.empty() ? Status{} : failure(Code::unavailable, "a shader program cannot be built: " + log);
}

UploadCount GlRenderer::add(const FurModel& model, const FurFields& fields) {
  assert(!has(model.id));
  UploadCount count;
  models_.try_emplace(model.id, gl_, model, fields, count);
  return count;
}

UploadCount GlRenderer::update(std::uint64_t model, const FurFields& fields) {
  assert(has(model));
  UploadCount count;
  models_.at(model).update(gl_, fields, count);
  return count;
}

std::size_t GlRenderer::bytes_of(std::uint64_t original) const {
  std::size_t bytes = 0;
  for (const auto& [id, model] : models_) bytes += model.original() == original ? model.bytes(gl_) : 0;
  return bytes;
}

void GlRenderer::forget(std::uint64_t original) {
  std::erase_if(models_, [&](const auto& model) { return model.second.original() == original; });
}

void GlRenderer::forget_all() {
  models_.clear();
  targets_ = {};
}

bool GlRenderer::has(const Coat& coat) const {
  return std::any_of(coats_.begin(), coats_.end(), [&](const CoatTextures& c) { return same_strands(c.coat(), coat); });
}

const CoatTextures& GlRenderer::textures_of(const Coat& coat) {
  const auto found =
      std::find_if(coats_.begin(), coats_.end(), [&](const CoatTextures& c) { return same_strands(c.coat(), coat); });
  if (found == coats_.end()) return add(coat, *coat_source_({coat}, {}));
  coats_.splice(coats_.begin(), coats_, found);
  return coats_.front();
}

std::optional<CoatNeed> GlRenderer::missing_coat(const FurFrame& frame) const {
  if (has(frame.coat)) return {};
  return CoatNeed{frame.coat};
}

const CoatTextures& GlRenderer::add(const Coat& coat, const Slices& slices) {
  if (coats_.size() == max_cached_coats) coats_.pop_back();
  UploadCount count;
  return coats_.emplace_front(gl_, coat, slices, count);
}

Status GlRenderer::prepare_targets(const FurFrame& frame, GLenum picture) {
  const int width = scaled(frame.width, frame.knobs.scale), height = scaled(frame.height, frame.knobs.scale);
  const bool complete = fit(targets_.drawn, GL_RGBA32F, width, height, true) &&
                        fit(targets_.picture, picture, frame.width, frame.height, false);
  if (complete) return {};
  targets_ = {};
  return no_memory_for_frame();
}

void GlRenderer::drop_large_targets() {
  if (targets_.drawn.width() * std::int64_t{targets_.drawn.height()} > max_kept_pixels) targets_ = {};
}

bool GlRenderer::fit(RenderTarget& target, GLenum format, int width, int height, bool depth) {
  if (target.matches(format, width, height)) return true;
  target = RenderTarget();
  target = RenderTarget(gl_, format, width, height, depth);
  return target.complete();
}

FrameBlock GlRenderer::block_of(const FurFrame& frame) {
  return make_frame_block(frame, textures_of(frame.coat).slices(), models_.at(frame.model).has_colours(),
                          targets_.drawn.height());
}

ShellView GlRenderer::shell_view(const FurFrame& frame, const FrameBlock& block,
                                 const std::optional<Area>& part) const {
  const bool sorted = frame.knobs.order == FragmentOrder::sorted;
  const float stretch = 1 + static_cast<float>(frame.coat.variation.length);
  ShellView view{frame.camera.position,
                 block.viewpoint.w,
                 frame.knobs.shells,
                 frame.knobs.shell_policy,
                 sorted ? -2.0f : furthest_back_facing,
                 block.world_to_clip,
                 stretch};
  view.depth_parts = sorted ? 1 : depth_part_count;
  if (part) view.part = cells_of(*part, targets_.drawn.width(), targets_.drawn.height());
  return view;
}

GlRenderer::Prepared GlRenderer::prepare_scene(const FurFrame& frame, const std::optional<Area>& part,
                                               DrawTimes& times) {
  const auto found = models_.find(frame.model);
  assert(found != models_.end());
  ModelBuffers& model = found->second;
  const CoatTextures& coat = textures_of(frame.coat);
  const Stopwatch making;
  const FrameBlock block = block_of(frame);
  const ShellView view = shell_view(frame, block, part);
  const auto lists = model.sort_for(gl_, view);
  if (has_tufts(frame.coat)) tufts_.prepare(gl_, frame.model, frame.coat.tufts, model);
  prepare_colours(frame, model);
  const std::string shape = shape_of(frame.coat, model);
  const FurDrawing shaped{frame, shape, model, lists, coat};
  if (ShadowMaps::wanted(frame) && shadows_.prepare(gl_, frame, block, shaped, curves_)) {
    gl_.Finish();
    times.shadow += making.milliseconds();
  }
  if (frame.ground) ground_.prepare(gl_, frame, model, lists.all, shadows_.scene());
  bind_blocks(frame, block);
  return {coat, model, lists, variant_of(frame, model), block, part};
}

void GlRenderer::prepare_colours(const FurFrame& frame, ModelBuffers& model) {
  if (has_pattern(frame.coat)) pattern_.prepare(gl_, frame.model, frame.coat, model);
  if (model.paint().changes_fur()) paint_.prepare(gl_, frame.coat);
}

void GlRenderer::bind_blocks(const FurFrame& frame, const FrameBlock& block) {
  gl_.NamedBufferData(frame_block_.id(), sizeof(FrameBlock), &block, GL_STREAM_DRAW);
  gl_.BindBufferBase(GL_UNIFORM_BUFFER, frame_binding, frame_block_.id());
  if (!frame.skin.empty()) {
    const SkinBlock skin = make_skin_block(frame.skin);
    gl_.NamedBufferData(skin_block_.id(), sizeof(SkinBlock), &skin, GL_STREAM_DRAW);
    gl_.BindBufferBase(GL_UNIFORM_BUFFER, skin_binding, skin_block_.id());
  }
  scattering_.prepare(gl_, frame);
}

void GlRenderer::draw_body(const FurFrame& frame, const Prepared& scene, const std::string& outputs) {
  const FurDrawing drawing = scene.drawing(frame).with(outputs);
  fur_.draw_skin(gl_, drawing);
  fur_.draw_dense(gl_, drawing);
  if (!frame.eyes.empty()) eyes_.draw(gl_, frame, outputs);
  draw_fur(drawing);
  if (frame.knobs.guard_hairs > 0) guard_hairs_.draw(gl_, frame, drawing);
  if (!frame.curves.empty()) curves_.draw(gl_, frame, drawing.variant);
}

void GlRenderer::draw_fur(const FurDrawing& drawing) {
  for (const ModelBuffers::DepthPart& part : drawing.lists.parts) {
    fur_.draw_back_facing(gl_, drawing, part);
    fur_.draw_facing(gl_, drawing, part);
  }
}

Status GlRenderer::draw_light(const FurFrame& frame, const Prepared& scene) {
  set_draw_state(gl_, targets_.drawn);
  const ScissorTest part(gl_, scene.part);
  gl_.DepthMask(GL_TRUE);
  clear_target(gl_, targets_.drawn, {});
  if (frame.ground) ground_.draw(gl_, frame, scene.variant);
  if (frame.knobs.order == FragmentOrder::sorted) return draw_sorted(frame, scene);
  draw_body(frame, scene, "");
  return {};
}

// The shells in the order of shells, from far to near: most lists then are in order already.
Status GlRenderer::draw_sorted(const FurFrame& frame, const Prepared& scene) {
  fur_.draw_skin(gl_, scene.drawing(frame));
  if (!frame.eyes.empty()) eyes_.draw(gl_, frame, "");
  const FurDrawing drawing = scene.drawing(frame).with("#define SORTED\n");
  return sorted_.draw(gl_, targets_.drawn, scene.part.value_or(area_of(targets_.drawn)), frame.knobs.shells, [&] {
    draw_fur(drawing);
    if (frame.knobs.guard_hairs > 0) guard_hairs_.draw(gl_, frame, drawing);
    if (!frame.curves.empty()) curves_.draw(gl_, frame, drawing.variant);
  });
}

RenderTarget GlRenderer::overlay_target(const FloatImage* overlay) const {
  if (!overlay) return {};
  RenderTarget target(gl_, GL_RGBA32F, overlay->width, overlay->height, false);
  if (target.complete())
    gl_.TextureSubImage2D(target.texture(), 0, 0, 0, overlay->width, overlay->height, GL_RGBA, GL_FLOAT,
                          overlay->rgba.data());
  return target;
}

Result<Image> GlRenderer::draw(const FurFrame& frame, const FloatImage* overlay, DrawTimes* times, const Pause& pause) {
  return draw_picture<Image>(frame, overlay, {GL_RGBA8, GL_UNSIGNED_BYTE, 255}, times, pause);
}

Result<Image16> GlRenderer::draw_deep(const FurFrame& frame, const FloatImage* overlay, DrawTimes* times,
                                      const Pause& pause) {
  return draw_picture<Image16>(frame, overlay, {GL_RGBA16, GL_UNSIGNED_SHORT, 65535}, times, pause);
}

template <class Picture>
Result<Picture> GlRenderer::draw_picture(const FurFrame& frame, const FloatImage* overlay, const PictureFormat& format,
                                         DrawTimes* times, const Pause& pause) {
  if (const Status status = prepare_targets(frame, format.target); !status.ok()) return status;
  DrawTimes taken;
  const Result<Prepared> scene = draw_in_pieces(frame, pause, taken);
  if (!scene) return scene.status();
  if (const Status done = finish_light(frame, overlay, format.largest, taken); !done.ok()) return done;
  const Stopwatch reading;
  Result<Picture> image = read_back<Picture>(targets_.picture, format.type);
  taken.read = reading.milliseconds();
  add_counts(taken.counters, take_counts());
  if (times) *times = taken;
  drop_large_targets();
  return image;
}

Status GlRenderer::finish_light(const FurFrame& frame, const FloatImage* overlay, int largest, DrawTimes& times) {
  const DrawClock clock(times);
  const RenderTarget over = overlay_target(overlay);
  if (overlay && !over.complete()) return no_memory_for_frame();
  resolve_.draw(gl_, frame, targets_.drawn, targets_.picture, largest, over.texture());
  if (const Status built = programs(); !built.ok()) return built;
  return wait_for(gl_);
}

FrameCounters GlRenderer::take_counts() const {
  const GlCounts counts = gl_.take_counts();
  return {.passes = counts.programs,
          .draws = counts.draws,
          .textures = counts.textures,
          .bytes = counts.bytes,
          .objects = counts.objects,
          .allocated = counts.allocated};
}

FrameCounters GlRenderer::take_counters() const {
  FrameCounters counters = take_counts();
  counters.fragments = fragments_.result();
  return counters;
}

}  // namespace pelage
