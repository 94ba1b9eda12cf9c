#include "renderer/passes/fur/fur_pass.h"

#include <algorithm>

#include "renderer/passes/draw/draw_state.h"

namespace pelage {

namespace shaders {
extern const char* const fur_vert;
extern const char* const fur_frag;
extern const char* const solid_frag;
extern const char* const skin_vert;
extern const char* const skin_frag;
}  // namespace shaders

namespace {

// Fur behind dense fur of something nearer is hidden by a coarse depth of it, written further away by a part of the
// fur's length over the cosine of the view, so that the layers of one coat do not hide each other. Without it the
// body's outer layers would cover an ear's fringe; with a whole length they shine through thin rims.
constexpr int solid_shells = 4;
constexpr float solid_push = 0.25f;

}  // namespace

FurPass::Shading::Shading(const Gl& gl, const std::string& defines)
    : skin(gl, shaders::skin_vert, shaders::skin_frag, defines),
      solid(gl, shaders::fur_vert, shaders::solid_frag, defines),
      fur(gl, shaders::fur_vert, shaders::fur_frag, defines) {}

FurPass::FurPass(const Gl& gl) { shading_of(gl, ""); }

std::vector<FurPass::Layer> FurPass::layers_of(const Knobs& knobs) {
  std::vector<Layer> layers;
  for (int set = 0; set < layer_sets; ++set) {
    const int shells = shells_of_set(knobs.shells, set);
    for (int shell = 0; shell < shells; ++shell) layers.push_back({set, shell, shells, steps_of_set(knobs.steps, set)});
  }
  std::stable_sort(layers.begin(), layers.end(),
                   [](const Layer& a, const Layer& b) { return a.height() < b.height(); });
  return layers;
}

const FurPass::Shading& FurPass::shading_of(const Gl& gl, const std::string& variant) {
  const auto [place, made] = shadings_.try_emplace(variant, gl, variant);
  if (made) failure_ += place->second.skin.log() + place->second.solid.log() + place->second.fur.log();
  return place->second;
}

void FurPass::bind(const Gl& gl, const ModelBuffers& model, const CoatTextures& coat) const {
  gl.BindVertexArray(model.vertex_array());
  gl.BindTextureUnit(0, coat.shapes());
  gl.BindTextureUnit(1, coat.colours());
  gl.BindTextureUnit(2, model.base_images());
}

void FurPass::draw_skin(const Gl& gl, const std::string& variant, const ModelBuffers::DrawLists& lists) {
  const Shading& shading = shading_of(gl, variant);
  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
  shading.skin.use();
  draw_list(gl, lists.all);
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  shading.solid.use();
  shading.solid.set("push", solid_push);
  shading.solid.set("layer_set", -1);
  for (int shell = 0; shell < solid_shells; ++shell)
    draw_layer(gl, shading.solid, lists.all, {0, shell, solid_shells, 4}, 1);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void FurPass::draw_fur(const Gl& gl, const std::string& variant, const Knobs& knobs,
                       const ModelBuffers::DrawLists& lists) {
  const Program& fur = shading_of(gl, variant).fur;
  gl.DepthMask(GL_FALSE);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  const std::vector<Layer> layers = layers_of(knobs);
  const auto draw = [&](const Layer& layer, const auto& of_sets, int side) {
    fur.set("layer_set", layer.set);
    draw_layer(gl, fur, of_sets[static_cast<std::size_t>(layer.set)], layer, side);
  };
  fur.use();
  fur.set("push", 0.0f);
  for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) draw(*layer, lists.averted, -1);
  for (const Layer& layer : layers) draw(layer, lists.facing, 1);
  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
}

void FurPass::draw_layer(const Gl& gl, const Program& program, const ModelBuffers::DrawList& list, const Layer& layer,
                         int side) const {
  if (list.count == 0) return;
  program.set("shell_count", layer.shells);
  program.set("shell", layer.shell);
  program.set("shell_side", side);
  program.set("step_count", layer.steps);
  draw_list(gl, list);
}

}  // namespace pelage
