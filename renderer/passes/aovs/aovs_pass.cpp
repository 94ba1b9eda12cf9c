#include "renderer/passes/aovs/aovs_pass.h"

#include <cassert>

#include "renderer/passes/draw/draw.h"
#include "renderer/shaders/constants.h"

namespace pelage {

namespace {

/// Location in renderer/shaders/aovs.glsl; 0 for AOVs that are not written there.
std::size_t place_of(Aov aov) {
  switch (aov) {
    case Aov::beauty:
    case Aov::alpha:
    case Aov::depth: return 0;
    case Aov::position: return 1;
    case Aov::normal: return 2;
    case Aov::tangent: return 3;
    case Aov::albedo: return 4;
    case Aov::direct: return 5;
    case Aov::shadow: return 6;
    case Aov::shell_count: return 7;
  }
  assert(false);
  return 0;
}

}  // namespace

AovTarget::AovTarget(const Gl& gl, std::span<const Aov> aovs, int width, int height)
    : width_(width), height_(height), framebuffer_(gl), depth_(gl) {
  std::array<GLenum, places> buffers{};
  for (const Aov aov : aovs) {
    const std::size_t place = place_of(aov);
    if (place == 0) continue;
    Texture texture(gl, GLenum{GL_TEXTURE_2D});
    gl.TextureStorage2D(texture.id(), 1, GL_RGBA32F, width, height);
    gl.TextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TextureParameteri(texture.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    buffers[place] = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(place);
    gl.NamedFramebufferTexture(framebuffer_.id(), buffers[place], texture.id(), 0);
    textures_[place] = std::move(texture);
  }
  gl.NamedRenderbufferStorage(depth_.id(), GL_DEPTH_COMPONENT32F, width, height);
  gl.NamedFramebufferRenderbuffer(framebuffer_.id(), GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
  gl.NamedFramebufferDrawBuffers(framebuffer_.id(), static_cast<GLsizei>(places), buffers.data());
  complete_ = gl.GetError() == GL_NO_ERROR &&
              gl.CheckNamedFramebufferStatus(framebuffer_.id(), GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

GLuint AovTarget::texture(Aov aov) const {
  assert(textures_[place_of(aov)]);
  return textures_[place_of(aov)].id();
}

bool AovTarget::holds(Aov aov) { return place_of(aov) != 0; }

void AovTarget::clear(const Gl& gl) const {
  const std::array<float, 4> nothing{};
  for (std::size_t place = 0; place < places; ++place) {
    if (textures_[place])
      gl.ClearNamedFramebufferfv(framebuffer_.id(), GL_COLOR, static_cast<GLint>(place), nothing.data());
  }
  const float far_away = 0;
  gl.ClearNamedFramebufferfv(framebuffer_.id(), GL_DEPTH, 0, &far_away);
}

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

GatherRule rule_of(Aov aov) {
  switch (aov) {
    case Aov::beauty:
    case Aov::alpha:
    case Aov::albedo:
    case Aov::direct:
    case Aov::shell_count: return GatherRule::mean;
    case Aov::position: return GatherRule::straight;
    case Aov::normal:
    case Aov::tangent: return GatherRule::unit;
    case Aov::shadow: return GatherRule::light_share;
    case Aov::depth: return GatherRule::middle;
  }
  assert(false);
  return GatherRule::mean;
}

}  // namespace

AovsPass::DistancePrograms::DistancePrograms(const Gl& gl, const std::string& variant)
    : skin(gl, shaders::skin_vert, shaders::distance_frag, variant),
      coverage(gl, shaders::fur_vert, shaders::coverage_frag, variant),
      crossing(gl, shaders::fur_vert, shaders::coverage_frag, variant + "#define CROSSING\n") {}

const AovsPass::DistancePrograms& AovsPass::distance_programs(const Gl& gl, const std::string& variant) {
  const auto [place, made] = distance_.try_emplace(variant, gl, variant);
  if (made) failure_ += place->second.skin.log() + place->second.coverage.log() + place->second.crossing.log();
  return place->second;
}

// What a frame blends, the other way round: guided curves and guard hairs, fur that is front-facing, fur turned
// away.
std::vector<AovsPass::Piece> AovsPass::pieces_inwards(const Gl& gl, const BodyPasses& body, const FurFrame& frame,
                                                      const FurDrawing& drawing) {
  const auto defines = [](bool crossing) {
    return std::string(crossing ? "#define COVERING\n#define CROSSING\n" : "#define COVERING\n");
  };
  std::vector<Piece> pieces;
  const auto add_shells = [&](const std::vector<FurPass::Shell>& shells) {
    const DistancePrograms& with = distance_programs(gl, drawing.variant);
    for (auto shell = shells.rbegin(); shell != shells.rend(); ++shell) {
      pieces.push_back([&gl, &with, &drawing, shell = *shell](bool crossing) {
        const Program& program = crossing ? with.crossing : with.coverage;
        FurPass::bind(gl, drawing);
        program.use();
        program.set("push", 0.0f);
        FurPass::draw_shell(gl, program, shell);
      });
    }
  };
  if (!frame.curves.empty())
    pieces.push_back(
        [&, defines](bool crossing) { body.curves.draw_plain(gl, frame, drawing.with(defines(crossing)).variant); });
  if (frame.knobs.guard_hairs > 0)
    pieces.push_back(
        [&, defines](bool crossing) { body.guard_hairs.draw_plain(gl, frame, drawing.with(defines(crossing))); });
  for (auto part = drawing.lists.parts.rbegin(); part != drawing.lists.parts.rend(); ++part) {
    add_shells(FurPass::facing_shells(drawing.frame.knobs, *part));
    add_shells(FurPass::back_facing_shells(drawing.frame.knobs, *part));
  }
  return pieces;
}

// Three draws of each piece, from the camera inwards: add its opacity to what covers a pixel after it; where that
// crosses half, keep the nearest distance; add it to what covers a pixel before the next one. Parts of one piece that
// share a place count together, and no fragment reads what is being written.
void AovsPass::draw_distance(const Gl& gl, const BodyPasses& body, const FurFrame& frame, const FurDrawing& drawing,
                             const RenderTarget& distance, const RenderTarget& covered) {
  draw_solid(gl, body, frame, drawing, covered, false);
  draw_solid(gl, body, frame, drawing, distance, true);
  gl.DepthMask(GL_FALSE);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE_MINUS_DST_COLOR, GL_ONE);
  gl.BindTextureUnit(covered_unit, covered.texture());
  for (const Piece& piece : pieces_inwards(gl, body, frame, drawing)) {
    gl.BindFramebuffer(GL_FRAMEBUFFER, covered.framebuffer());
    gl.ColorMask(GL_TRUE, GL_FALSE, GL_FALSE, GL_FALSE);
    piece(false);
    gl.BindFramebuffer(GL_FRAMEBUFFER, distance.framebuffer());
    gl.BlendEquation(GL_MAX);
    piece(true);
    gl.BlendEquation(GL_FUNC_ADD);
    gl.BindFramebuffer(GL_FRAMEBUFFER, covered.framebuffer());
    gl.ColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE);
    piece(false);
  }
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.Disable(GL_BLEND);
  gl.DepthMask(GL_TRUE);
}

void AovsPass::draw_solid(const Gl& gl, const BodyPasses& body, const FurFrame& frame, const FurDrawing& drawing,
                          const RenderTarget& target, bool distance) {
  set_draw_state(gl, target);
  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
  clear_target(gl, target, {});
  FurPass::bind(gl, drawing);
  if (distance) {
    distance_programs(gl, drawing.variant).skin.use();
    draw_list(gl, drawing.lists.all);
  }
  body.fur.draw_depth(gl, drawing);
  if (frame.eyes.empty()) return;
  if (!distance) gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  body.eyes.draw(gl, frame, "#define COVERING\n");
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void AovsPass::gather(const Gl& gl, Aov aov, GLuint drawn, float scale, const RenderTarget& picture) {
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
  program.set("rule", static_cast<int>(rule_of(aov)));
  gl.BindTextureUnit(source_unit, drawn);
  gl.BindVertexArray(nothing_.id());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace pelage
