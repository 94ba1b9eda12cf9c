#include "renderer/passes/fur/fur_pass.h"

#include <algorithm>

#include "renderer/passes/draw/draw.h"
#include "renderer/shaders/constants.h"

namespace pelage {

namespace shaders {
extern const char* const fur_vert;
extern const char* const fur_frag;
extern const char* const lengyel_vert;
extern const char* const lengyel_frag;
extern const char* const solid_frag;
extern const char* const skin_vert;
extern const char* const skin_frag;
}  // namespace shaders

namespace {

// Fur behind dense fur of something nearer is hidden by a coarse depth of it, written further away by a part of the
// fur's length over the cosine of the view, so that the shells of one coat do not hide each other. Without it the
// body's outer shells would cover an ear's fringe; with a whole length they shine through thin rims.
constexpr int solid_shells = 4;
constexpr float solid_push = 0.25f;

}  // namespace

FurPass::Shading::Shading(const Gl& gl, const std::string& defines, bool at_vertices)
    : skin(gl, shaders::skin_vert, shaders::skin_frag, defines),
      solid(gl, shaders::fur_vert, shaders::solid_frag, defines),
      fur(gl, at_vertices ? shaders::lengyel_vert : shaders::fur_vert,
          at_vertices ? shaders::lengyel_frag : shaders::fur_frag, defines) {}

FurPass::FurPass(const Gl& gl) { shading_of(gl, "", false); }

namespace {

std::vector<FurPass::Shell> shells_of(const Knobs& knobs, const std::vector<ModelBuffers::ShellList>& lists,
                                      const DepthRange& range, int side) {
  const int lod = max_lod(knobs.shells, knobs.shell_policy);
  std::vector<FurPass::Shell> result;
  for (const ModelBuffers::ShellList& each : lists)
    result.push_back({each.shell, knobs.shells, lod, knobs.steps, each.list, side, range});
  return result;
}

}  // namespace

std::vector<FurPass::Shell> FurPass::back_facing_shells(const Knobs& knobs, const ModelBuffers::DepthPart& part) {
  return shells_of(knobs, part.back_facing, part.range, -1);
}

std::vector<FurPass::Shell> FurPass::facing_shells(const Knobs& knobs, const ModelBuffers::DepthPart& part) {
  return shells_of(knobs, part.facing, part.range, 1);
}

const Program& FurPass::skin_of(const Gl& gl, const std::string& defines) {
  const auto [place, made] = skins_.try_emplace(defines, gl, shaders::skin_vert, shaders::skin_frag, defines);
  if (made) failure_ += place->second.log();
  return place->second;
}

const FurPass::Shading& FurPass::shading_of(const Gl& gl, const FurDrawing& drawing) {
  return shading_of(gl, drawing.variant, drawing.frame.look.shading == ShadingModel::lengyel);
}

const FurPass::Shading& FurPass::shading_of(const Gl& gl, const std::string& variant, bool at_vertices) {
  const auto [place, made] = shadings_.try_emplace(variant, gl, variant, at_vertices);
  if (made) failure_ += place->second.skin.log() + place->second.solid.log() + place->second.fur.log();
  return place->second;
}

void FurPass::bind(const Gl& gl, const FurDrawing& drawing) {
  gl.BindVertexArray(drawing.model.vertex_array());
  gl.BindTextureUnit(shapes_unit, drawing.coat.shapes());
  gl.BindTextureUnit(colours_unit, drawing.coat.colours());
  gl.BindTextureUnit(skin_images_unit, drawing.model.base_images());
}

void FurPass::draw_skin(const Gl& gl, const FurDrawing& drawing) {
  bind(gl, drawing);
  const Shading& shading = shading_of(gl, drawing);
  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
  shading.skin.use();
  draw_list(gl, drawing.lists.furred);
  if (drawing.lists.bare.count > 0) {
    skin_of(gl, drawing.variant + "#define BARE_SKIN\n").use();
    draw_list(gl, drawing.lists.bare);
  }
}

void FurPass::draw_depth(const Gl& gl, const FurDrawing& drawing) {
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  draw_skin(gl, drawing);
  draw_dense(gl, drawing);
}

void FurPass::draw_dense(const Gl& gl, const FurDrawing& drawing) {
  const Program& solid = shading_of(gl, drawing).solid;
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  solid.use();
  solid.set("push", solid_push);
  for (int shell = 0; shell < solid_shells; ++shell)
    draw_shell(gl, solid, {shell, solid_shells, 0, 1, drawing.lists.shown, 1, {}});
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void FurPass::draw_back_facing(const Gl& gl, const FurDrawing& drawing, const ModelBuffers::DepthPart& part) {
  draw_fur(gl, drawing, back_facing_shells(drawing.frame.knobs, part));
}

void FurPass::draw_facing(const Gl& gl, const FurDrawing& drawing, const ModelBuffers::DepthPart& part) {
  draw_fur(gl, drawing, facing_shells(drawing.frame.knobs, part));
}

void FurPass::draw_fur(const Gl& gl, const FurDrawing& drawing, const std::vector<Shell>& shells) {
  bind(gl, drawing);
  const Program& fur = shading_of(gl, drawing).fur;
  gl.DepthMask(GL_FALSE);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  fur.use();
  fur.set("push", 0.0f);
  for (const Shell& shell : shells) draw_shell(gl, fur, shell);
  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
}

void FurPass::draw_shell(const Gl& gl, const Program& program, const Shell& shell) {
  if (shell.list.count == 0) return;
  program.set("shell_count", shell.shells);
  program.set("shell", shell.shell);
  program.set("max_shell_lod", shell.max_lod);  // is there with SHELL_LOD alone
  program.set("shell_side", shell.side);
  program.set("step_count", shell.steps);
  program.set("part_begin", shell.range.inverse_begin());
  program.set("part_end", shell.range.inverse_end());
  draw_list(gl, shell.list);
}

}  // namespace pelage
