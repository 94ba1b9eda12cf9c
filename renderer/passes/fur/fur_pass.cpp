#include "renderer/passes/fur/fur_pass.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace pelage {

namespace shaders {
extern const char* const fur_vert;
extern const char* const fur_frag;
extern const char* const solid_frag;
extern const char* const skin_vert;
extern const char* const skin_frag;
}  // namespace shaders

namespace {

// Fur behind dense fur of something nearer is hidden by a coarse depth of it, written a fur length further away so that
// the layers of one coat do not hide each other. Without it the body's outer layers would cover an ear's fringe.
constexpr int solid_shells = 4;
constexpr float solid_push = 0.5f;

void draw_list(const Gl& gl, const ModelBuffers::DrawList& list) {
  const auto offset = static_cast<std::uintptr_t>(list.first) * sizeof(GLuint);
  gl.DrawElements(GL_TRIANGLES, list.count, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset));
}

void clear(const Gl& gl, const RenderTarget& target) {
  const std::array<float, 4> nothing{};
  const float far_away = 0;
  gl.ClearNamedFramebufferfv(target.framebuffer(), GL_COLOR, 0, nothing.data());
  gl.ClearNamedFramebufferfv(target.framebuffer(), GL_DEPTH, 0, &far_away);
}

void set_state(const Gl& gl, const RenderTarget& target) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
  gl.Viewport(0, 0, target.width(), target.height());
  gl.ClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);  // rows from the top, depth as reversed floats want it
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_GEQUAL);
  gl.Disable(GL_CULL_FACE);
}

}  // namespace

FurPass::FurPass(const Gl& gl)
    : skin_(gl, shaders::skin_vert, shaders::skin_frag), solid_(gl, shaders::fur_vert, shaders::solid_frag),
      fur_(gl, shaders::fur_vert, shaders::fur_frag), block_(gl) {
  gl.NamedBufferData(block_.id(), sizeof(FrameBlock), nullptr, GL_STREAM_DRAW);
}

std::vector<FurPass::Layer> FurPass::layers_of(const Knobs& knobs) {
  std::vector<Layer> layers;
  for (int set = 0; set < layer_sets; ++set) {
    const int shells = shells_of_set(knobs.shells, set);
    for (int shell = 0; shell < shells; ++shell) layers.push_back({set, shell, shells, steps_of_set(knobs.steps, set)});
  }
  std::stable_sort(layers.begin(), layers.end(), [](const Layer& a, const Layer& b) { return a.height() < b.height(); });
  return layers;
}

void FurPass::draw(const Gl& gl, const FrameBlock& block, const Knobs& knobs, ModelBuffers& model,
                   const CoatTextures& coat, const RenderTarget& target,
                   const std::function<void()>& before_fur) {
  clear(gl, target);
  set_state(gl, target);
  const auto lists = model.sort_for(gl, {glm::vec3(block.eye), block.eye.w, knobs.shells, knobs.shell_policy});
  gl.NamedBufferSubData(block_.id(), 0, sizeof(FrameBlock), &block);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, 0, block_.id());
  bind(gl, model, coat);
  draw_skin(gl, lists);
  if (before_fur) {
    before_fur();
    bind(gl, model, coat);
  }
  draw_fur(gl, lists, knobs);
}

void FurPass::bind(const Gl& gl, const ModelBuffers& model, const CoatTextures& coat) {
  gl.BindVertexArray(model.vertex_array());
  gl.BindTextureUnit(0, coat.shapes());
  gl.BindTextureUnit(1, coat.colours());
  gl.BindTextureUnit(2, model.base_images());
}

void FurPass::draw_skin(const Gl& gl, const ModelBuffers::DrawLists& lists) const {
  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
  skin_.use();
  draw_list(gl, lists.all);
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  solid_.use();
  solid_.set("push", solid_push);
  solid_.set("layer_set", -1);
  for (int shell = 0; shell < solid_shells; ++shell) draw_layer(gl, solid_, lists.all, {0, shell, solid_shells, 4}, 1);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void FurPass::draw_fur(const Gl& gl, const ModelBuffers::DrawLists& lists, const Knobs& knobs) const {
  gl.DepthMask(GL_FALSE);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  const std::vector<Layer> layers = layers_of(knobs);
  const auto draw = [&](const Layer& layer, const auto& of_sets, int side) {
    fur_.set("layer_set", layer.set);
    draw_layer(gl, fur_, of_sets[static_cast<std::size_t>(layer.set)], layer, side);
  };
  fur_.use();
  fur_.set("push", 0.0f);
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
