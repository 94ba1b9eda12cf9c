#include "renderer/shells/shells_renderer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "renderer/coat/strand_tile.h"
#include "renderer/pattern/pattern.h"
#include "renderer/shaders/constants.h"
#include "renderer/shells/draw/draw.h"
#include "renderer/upload/blocks.h"

namespace pelage {

namespace {

constexpr std::size_t max_cached_coats = 3;  // 90 MB each
constexpr std::int64_t max_cached_pixels = 2048 * 2048;

bool has_tufts(const Coat& coat) { return coat.tufts.gather > 0; }

/// Returns the #define lines of a frame's light and colours.
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

/// Returns the #define lines of what shapes and colours the fur: pattern, tufts and painted fields.
std::string shape_of(const Coat& coat, const ModelBuffers& model) {
  return std::string(has_pattern(coat) ? "#define PATTERN\n" : "") + (has_tufts(coat) ? "#define TUFTS\n" : "") +
         model.paint_defines();
}

/// Returns the #define lines of all that a frame uses, so that what it does not use is not even compiled.
std::string variant_of(const FurFrame& frame, const ModelBuffers& model) {
  const Layering& shells = frame.knobs.shells;
  return std::string(ShadowMaps::wanted(frame) ? "#define SHADOW_MAPS\n" : "") + light_of(frame, model.has_colours()) +
         shape_of(frame.coat(), model) + (frame.skin.empty() ? "" : "#define BARE_SKIN\n") +
         (max_lod(shells.count, shells.policy) > 0 ? "#define SHELL_LOD\n" : "") + "#define SHADING_MODEL " +
         std::to_string(static_cast<int>(frame.look.shading)) + "\n";
}

ShellView view_of(const FurFrame& frame, const FrameBlock& block) {
  const Layering& shells = frame.knobs.shells;
  const bool sorted = shells.order == FragmentOrder::sorted;
  return {frame.camera.position, block.viewpoint.w, shells.count, shells.policy, sorted ? -2.0f : furthest_back_facing};
}

int scaled(int pixels, double scale) { return std::max(1, static_cast<int>(std::lround(pixels * scale))); }

}  // namespace

Result<std::unique_ptr<ShellsRenderer>> ShellsRenderer::create(const Gl& gl, std::size_t sorted_bytes,
                                                               CoatSource coats) {
  std::unique_ptr<ShellsRenderer> renderer(new ShellsRenderer(gl, sorted_bytes, std::move(coats)));
  if (const Status status = renderer->programs(); !status.ok()) return status;
  return renderer;
}

ShellsRenderer::ShellsRenderer(const Gl& gl, std::size_t sorted_bytes, CoatSource coats)
    : gl_(gl),
      coat_source_(std::move(coats)),
      fur_(gl),
      shadows_(gl),
      sorted_(gl, sorted_bytes),
      pattern_(gl),
      tufts_(gl),
      paint_(gl),
      scattering_(gl),
      frame_block_(gl),
      skin_block_(gl),
      fragments_(gl) {}

Status ShellsRenderer::programs() const {
  const std::string log = fur_.failure() + shadows_.failure() + sorted_.failure();
  return log.empty() ? Status{} : failure(Code::unavailable, "a shader program cannot be built: " + log);
}

UploadCount ShellsRenderer::add(const FurModel& model, const FurFields& fields) {
  assert(!has(model.id));
  UploadCount count;
  models_.try_emplace(model.id, gl_, model, fields, count);
  return count;
}

UploadCount ShellsRenderer::update(std::uint64_t model, const FurFields& fields) {
  assert(has(model));
  UploadCount count;
  models_.at(model).update(gl_, fields, count);
  return count;
}

std::size_t ShellsRenderer::bytes_of(std::uint64_t original) const {
  std::size_t bytes = 0;
  for (const auto& [id, model] : models_) bytes += model.original() == original ? model.bytes(gl_) : 0;
  return bytes;
}

void ShellsRenderer::forget(std::uint64_t original) {
  std::erase_if(models_, [&](const auto& model) { return model.second.original() == original; });
}

void ShellsRenderer::forget_all() { models_.clear(), target_ = {}; }

bool ShellsRenderer::has(const Coat& coat) const {
  return std::any_of(coats_.begin(), coats_.end(), [&](const CoatTextures& c) { return same_strands(c.coat(), coat); });
}

const CoatTextures& ShellsRenderer::textures_of(const Coat& coat) {
  const auto found =
      std::find_if(coats_.begin(), coats_.end(), [&](const CoatTextures& c) { return same_strands(c.coat(), coat); });
  if (found != coats_.end()) {
    coats_.splice(coats_.begin(), coats_, found);
    return coats_.front();
  }
  if (coats_.size() == max_cached_coats) coats_.pop_back();
  UploadCount count;
  return coats_.emplace_front(gl_, coat, *coat_source_(coat), count);
}

bool ShellsRenderer::fit_target(const FurFrame& frame) {
  const int width = scaled(frame.width, frame.knobs.scale), height = scaled(frame.height, frame.knobs.scale);
  if (target_.matches(GL_RGBA32F, width, height)) return true;
  target_ = {};
  target_ = RenderTarget(gl_, GL_RGBA32F, width, height, true);
  if (target_.complete()) return true;
  target_ = {};
  return false;
}

FurDrawing ShellsRenderer::prepare(const FurFrame& frame, ModelBuffers& model, const CoatTextures& coat,
                                   ModelBuffers::DrawLists& lists) {
  const FrameBlock block = make_frame_block(frame, coat.slices(), model.has_colours(), target_.height());
  lists = model.lists_for(gl_, view_of(frame, block));
  if (has_tufts(frame.coat())) tufts_.prepare(gl_, frame.model, frame.coat().tufts, model);
  if (has_pattern(frame.coat())) pattern_.prepare(gl_, frame.model, frame.coat(), model);
  if (model.painted().fur) paint_.prepare(gl_, frame.coat());
  if (ShadowMaps::wanted(frame))
    shadows_.prepare(gl_, frame, block, {frame, shape_of(frame.coat(), model), model, lists, coat});
  bind_blocks(frame, block);
  return {frame, variant_of(frame, model), model, lists, coat};
}

void ShellsRenderer::bind_blocks(const FurFrame& frame, const FrameBlock& block) {
  gl_.NamedBufferData(frame_block_.id(), sizeof(FrameBlock), &block, GL_STREAM_DRAW);
  gl_.BindBufferBase(GL_UNIFORM_BUFFER, frame_binding, frame_block_.id());
  if (!frame.skin.empty()) {
    const SkinBlock skin = make_skin_block(frame.skin);
    gl_.NamedBufferData(skin_block_.id(), sizeof(SkinBlock), &skin, GL_STREAM_DRAW);
    gl_.BindBufferBase(GL_UNIFORM_BUFFER, skin_binding, skin_block_.id());
  }
  scattering_.prepare(gl_, frame);
}

Status ShellsRenderer::draw_shells(const FurDrawing& drawing) {
  set_draw_state(gl_, target_);
  gl_.DepthMask(GL_TRUE);
  clear_target(gl_, target_, {});
  fur_.draw_skin(gl_, drawing);
  if (drawing.frame.knobs.shells.order == FragmentOrder::sorted) return draw_sorted(drawing);
  fur_.draw_dense(gl_, drawing);
  fur_.draw_shells(gl_, drawing);
  return {};
}

// Draws the shells in the same order as unsorted ones, from far to near, so that most lists are already in order.
Status ShellsRenderer::draw_sorted(const FurDrawing& drawing) {
  const FurDrawing fragments = drawing.with("#define SORTED\n");
  return sorted_.draw(gl_, target_, {0, 0, target_.width(), target_.height()}, drawing.frame.knobs.shells.count,
                      [&] { fur_.draw_shells(gl_, fragments); });
}

Result<FloatImage> ShellsRenderer::read_back() const {
  auto image = empty_picture<FloatImage>(target_.width(), target_.height());
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, target_.framebuffer());
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_.ReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_FLOAT, image.rgba.data());
  if (gl_.GetError() != GL_NO_ERROR) return failure(Code::internal, "a GL error while drawing");
  return image;
}

Result<FloatImage> ShellsRenderer::draw(const FurFrame& frame, FrameCounters& counters) {
  Result<FloatImage> light = drawn(frame, counters);
  const bool silent = !light && light.status().code == Code::unavailable && programs().ok();
  lost_ = lost_ || silent || gl_.GetGraphicsResetStatus() != GL_NO_ERROR;
  if (lost_ && light) return failure(Code::unavailable, "the GL was reset");
  return light;
}

Result<FloatImage> ShellsRenderer::drawn(const FurFrame& frame, FrameCounters& counters) {
  if (!fit_target(frame)) return failure(Code::too_large, "no memory for a frame of this size", "/width");
  ModelBuffers& model = models_.at(frame.model);
  const CoatTextures& coat = textures_of(frame.coat());
  ModelBuffers::DrawLists lists;
  fragments_.begin();
  const Status drawn = draw_shells(prepare(frame, model, coat, lists));
  fragments_.end();
  if (!drawn.ok()) return drawn;
  if (const Status built = programs(); !built.ok()) return built;
  if (const Status answer = wait_for(gl_); !answer.ok()) return answer;
  Result<FloatImage> light = read_back();
  const GlCounts counts = gl_.take_counts();
  counters = {.passes = counts.programs,
              .draws = counts.draws,
              .textures = counts.textures,
              .bytes = counts.bytes,
              .fragments = fragments_.result(),
              .objects = counts.objects,
              .allocated = counts.allocated};
  if (target_.width() * std::int64_t{target_.height()} > max_cached_pixels) target_ = {};
  return light;
}

}  // namespace pelage
