#include "renderer/shells/fur/fur_pass.h"

#include <algorithm>

#include "renderer/shaders/constants.h"
#include "renderer/shells/draw/draw.h"

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

// A coarse depth of dense fur hides fur further behind. It is written further away than it is, by a share of the fur's
// length over the cosine of the view, so that the shells of one coat do not hide each other. Without it, the body's
// outer shells would cover an ear's fringe; with a whole length they would show through thin rims.
constexpr int solid_shells = 4;
constexpr float solid_push = 0.25f;  // lengths of the fur

}  // namespace

FurPass::Shading::Shading(const Gl& gl, const std::string& defines, bool at_vertices)
    : skin(gl, shaders::skin_vert, shaders::skin_frag, defines),
      solid(gl, shaders::fur_vert, shaders::solid_frag, defines),
      fur(gl, at_vertices ? shaders::lengyel_vert : shaders::fur_vert,
          at_vertices ? shaders::lengyel_frag : shaders::fur_frag, defines) {}

FurPass::FurPass(const Gl& gl) { shading_of(gl, "", false); }

const FurPass::Shading& FurPass::shading_of(const Gl& gl, const FurDrawing& drawing) {
  return shading_of(gl, drawing.variant, drawing.frame.look.shading == ShadingModel::lengyel);
}

const FurPass::Shading& FurPass::shading_of(const Gl& gl, const std::string& variant, bool at_vertices) {
  const auto [entry, made] = shadings_.try_emplace(variant, gl, variant, at_vertices);
  if (made) failure_ += entry->second.skin.log() + entry->second.solid.log() + entry->second.fur.log();
  return entry->second;
}

void FurPass::bind(const Gl& gl, const FurDrawing& drawing) {
  gl.BindVertexArray(drawing.model.vertex_array());
  gl.BindTextureUnit(shapes_unit, drawing.coat.shapes());
  gl.BindTextureUnit(colours_unit, drawing.coat.colours());
  gl.BindTextureUnit(skin_images_unit, drawing.model.base_images());
}

void FurPass::draw_skin(const Gl& gl, const FurDrawing& drawing) {
  bind(gl, drawing);
  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
  shading_of(gl, drawing).skin.use();
  draw_list(gl, drawing.lists.all);
}

namespace {

/// How a shell is drawn: the number of shells, how often that may be halved, and the side from which the ray enters its
/// slab: 1 from outside, -1 from inside. A program of fur_vertex.glsl has to be in use.
struct ShellDrawing {
  int shells, max_lod, side;

  void draw(const Gl& gl, const Program& program, int shell, const ModelBuffers::DrawList& list) const {
    if (list.count == 0) return;
    program.set("shell_count", shells);
    program.set("shell", shell);
    program.set("max_shell_lod", max_lod);  // exists only with SHELL_LOD
    program.set("shell_side", side);
    draw_list(gl, list);
  }
};

}  // namespace

void FurPass::draw_dense(const Gl& gl, const FurDrawing& drawing) {
  const Program& solid = shading_of(gl, drawing).solid;
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  solid.use();
  solid.set("push", solid_push);
  for (int shell = 0; shell < solid_shells; ++shell)
    ShellDrawing{solid_shells, 0, 1}.draw(gl, solid, shell, drawing.lists.visible);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void FurPass::draw_shells(const Gl& gl, const FurDrawing& drawing) {
  bind(gl, drawing);
  const Program& fur = shading_of(gl, drawing).fur;
  const Layering& shells = drawing.frame.knobs.shells;
  const int lod = max_lod(shells.count, shells.policy);
  gl.DepthMask(GL_FALSE);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  fur.use();
  fur.set("push", 0.0f);
  for (const auto& [shell, list] : drawing.lists.back_facing)
    ShellDrawing{shells.count, lod, -1}.draw(gl, fur, shell, list);
  for (const auto& [shell, list] : drawing.lists.facing) ShellDrawing{shells.count, lod, 1}.draw(gl, fur, shell, list);
  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
}

}  // namespace pelage
