#include "renderer/passes/layers/layers_pass.h"

#include <cassert>

#include "renderer/passes/draw/draw_state.h"

namespace pelage {

namespace shaders {
extern const char* const whole_target_vert;
extern const char* const skin_vert;
extern const char* const fur_vert;
extern const char* const gather_frag;
extern const char* const distance_frag;
extern const char* const coverage_frag;
}  // namespace shaders

namespace {

enum class GatherRule { mean, straight, unit, light_share, middle };  // numbers of gather.frag

GatherRule rule_of(FrameLayer layer) {
  switch (layer) {
    case FrameLayer::beauty:
    case FrameLayer::alpha:
    case FrameLayer::albedo:
    case FrameLayer::direct:
    case FrameLayer::layer_count: return GatherRule::mean;
    case FrameLayer::position: return GatherRule::straight;
    case FrameLayer::normal:
    case FrameLayer::tangent: return GatherRule::unit;
    case FrameLayer::shadow: return GatherRule::light_share;
    case FrameLayer::depth: return GatherRule::middle;
  }
  assert(false);
  return GatherRule::mean;
}

}  // namespace

LayersPass::DistancePrograms::DistancePrograms(const Gl& gl, const std::string& variant)
    : skin(gl, shaders::skin_vert, shaders::distance_frag, variant),
      coverage(gl, shaders::fur_vert, shaders::coverage_frag, variant),
      crossing(gl, shaders::fur_vert, shaders::coverage_frag, variant + "#define CROSSING\n") {}

const LayersPass::DistancePrograms& LayersPass::distance_programs(const Gl& gl, const std::string& variant) {
  const auto [place, made] = distance_.try_emplace(variant, gl, variant);
  if (made) failure_ += place->second.skin.log() + place->second.coverage.log() + place->second.crossing.log();
  return place->second;
}

void LayersPass::draw(const Gl& gl, FurPass& fur, const FurDrawing& drawing, const LayerTarget& target) {
  set_draw_state(gl, target.framebuffer(), target.width(), target.height());
  gl.DepthMask(GL_TRUE);
  target.clear(gl);
  const std::string variant = drawing.variant + "#define LAYERS\n";
  const FurDrawing layers{drawing.knobs, variant, drawing.model, drawing.lists, drawing.coat};
  fur.draw_skin(gl, layers);
  fur.draw_dense(gl, layers);
  fur.draw_averted(gl, layers);
  fur.draw_facing(gl, layers);
}

void LayersPass::draw_distance(const Gl& gl, FurPass& fur, const FurDrawing& drawing, const RenderTarget& distance,
                               const RenderTarget& covered) {
  const DistancePrograms& with = distance_programs(gl, drawing.variant);
  for (const RenderTarget* target : {&covered, &distance}) {
    set_draw_state(gl, *target);
    gl.DepthMask(GL_TRUE);
    gl.Disable(GL_BLEND);
    clear_target(gl, *target, {});
    FurPass::bind(gl, drawing);
    if (target == &distance) {
      with.skin.use();
      draw_list(gl, drawing.lists.all);
    }
    fur.draw_depth(gl, drawing);
  }
  draw_crossings(gl, with, drawing, distance, covered);
}

// Three draws of each shell, from the eye inwards: add its opacity to what covers a pixel after it; where that crosses
// half, keep the nearest distance; add it to what covers a pixel before the next one. Pieces of one shell that share a
// place count together, and no fragment reads what is being written.
void LayersPass::draw_crossings(const Gl& gl, const DistancePrograms& with, const FurDrawing& drawing,
                                const RenderTarget& distance, const RenderTarget& covered) const {
  const auto draw = [&](const Program& program, const RenderTarget& target, const FurPass::Shell& shell) {
    gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    program.use();
    program.set("push", 0.0f);
    FurPass::draw_shell(gl, program, shell);
  };
  gl.DepthMask(GL_FALSE);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE_MINUS_DST_COLOR, GL_ONE);
  gl.BindTextureUnit(1, covered.texture());
  std::vector<FurPass::Shell> shells = FurPass::averted_shells(drawing.knobs, drawing.lists);
  const std::vector<FurPass::Shell> facing = FurPass::facing_shells(drawing.knobs, drawing.lists);
  shells.insert(shells.end(), facing.begin(), facing.end());
  for (auto shell = shells.rbegin(); shell != shells.rend(); ++shell) {
    gl.ColorMask(GL_TRUE, GL_FALSE, GL_FALSE, GL_FALSE);
    draw(with.coverage, covered, *shell);
    gl.BlendEquation(GL_MAX);
    draw(with.crossing, distance, *shell);
    gl.BlendEquation(GL_FUNC_ADD);
    gl.ColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE);
    draw(with.coverage, covered, *shell);
  }
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.Disable(GL_BLEND);
  gl.DepthMask(GL_TRUE);
}

void LayersPass::gather(const Gl& gl, FrameLayer layer, GLuint drawn, float scale, const RenderTarget& picture) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, picture.framebuffer());
  gl.Viewport(0, 0, picture.width(), picture.height());
  gl.Disable(GL_DEPTH_TEST);
  if (!gather_) {
    gather_.emplace(gl, shaders::whole_target_vert, shaders::gather_frag);
    failure_ += gather_->log();
  }
  const Program& program = *gather_;
  program.use();
  program.set("scale", scale);
  program.set("rule", static_cast<int>(rule_of(layer)));
  gl.BindTextureUnit(0, drawn);
  gl.BindVertexArray(nothing_.id());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace pelage
