#include "renderer/shells/scene_shadow/scene_shadow_pass.h"

#include "renderer/shaders/constants.h"
#include "renderer/shells/draw/draw.h"

namespace pelage {

namespace shaders {
extern const char* const skin_vert;
extern const char* const light_depth_frag;
extern const char* const occlusion_frag;
extern const char* const whole_target_vert;
extern const char* const shadow_width_frag;
}  // namespace shaders

namespace {

constexpr auto bias = static_cast<float>(cast_bias);
constexpr float nowhere = 1e4f;  // depth where no skin is visible from the light, sizes

}  // namespace

SceneShadowPass::SceneShadowPass(const Gl& gl)
    : depth_(gl, shaders::skin_vert, shaders::light_depth_frag),
      hull_(gl, shaders::skin_vert, shaders::light_depth_frag, "#define HULL\n"),
      occlusion_(gl, shaders::skin_vert, shaders::occlusion_frag),
      width_(gl, shaders::whole_target_vert, shaders::shadow_width_frag) {}

void SceneShadowPass::draw_hull(const Gl& gl, const ModelBuffers::DrawList& triangles, const LightView& light,
                                const RenderTarget& target) const {
  draw_depths(gl, hull_, triangles, light, target);
}

void SceneShadowPass::draw_depths(const Gl& gl, const Program& program, const ModelBuffers::DrawList& triangles,
                                  const LightView& light, const RenderTarget& target) {
  set_draw_state(gl, target);
  gl.DepthMask(GL_TRUE);
  clear_target(gl, target, {nowhere, 0, 0, 0});
  gl.Disable(GL_BLEND);
  program.use();
  program.set("axis", glm::vec3(light.axis));
  program.set("offset", light.axis.w);
  draw_list(gl, triangles);
}

void SceneShadowPass::draw(const Gl& gl, const ModelBuffers::DrawList& triangles, const LightView& light,
                           const SceneShadowTargets& targets) const {
  draw_depths(gl, depth_, triangles, light, targets.depth);
  draw_occlusion(gl, triangles, light, targets);
  set_draw_state(gl, targets.width);
  gl.Disable(GL_DEPTH_TEST);
  gl.BindTextureUnit(width_maps_unit, targets.occlusion.texture());
  width_.use();
  width_.set("ratio", targets.occlusion.width() / targets.width.width());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

void SceneShadowPass::draw_occlusion(const Gl& gl, const ModelBuffers::DrawList& triangles, const LightView& light,
                                     const SceneShadowTargets& targets) const {
  set_draw_state(gl, targets.occlusion);
  clear_target(gl, targets.occlusion, {});
  gl.Disable(GL_DEPTH_TEST);
  gl.Enable(GL_BLEND);
  gl.BlendEquation(GL_MAX);
  gl.BindTextureUnit(depth_maps_unit, targets.depth.texture());
  occlusion_.use();
  occlusion_.set("axis", glm::vec3(light.axis));
  occlusion_.set("offset", light.axis.w);
  occlusion_.set("bias", bias);
  draw_list(gl, triangles);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.Disable(GL_BLEND);
}

}  // namespace pelage
