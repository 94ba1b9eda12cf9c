#include "renderer/passes/curves/curves_pass.h"

#include <cassert>
#include <numeric>

#include "renderer/passes/draw/draw.h"
#include "renderer/shaders/constants.h"

namespace pelage {

namespace shaders {
extern const char* const curve_vert;
extern const char* const curve_frag;
extern const char* const curve_shadow_frag;
}  // namespace shaders

namespace {

constexpr float nowhere = 1e30f;  // depth of the nearest curve where there is none, sizes

template <class T>
void send(const Gl& gl, const Buffer& buffer, const std::vector<T>& values, GLenum usage) {
  gl.NamedBufferData(buffer.id(), static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), usage);
}

}  // namespace

const Program& CurvesPass::program_of(const Gl& gl, const std::string& variant) {
  const auto [place, made] = programs_.try_emplace(variant, gl, shaders::curve_vert, shaders::curve_frag, variant);
  if (made) failure_ += place->second.log();
  return place->second;
}

void CurvesPass::make_buffers(const Gl& gl) {
  array_ = VertexArray(gl);
  elements_ = Buffer(gl), points_ = Buffer(gl), styles_ = Buffer(gl), numbers_ = Buffer(gl);
  std::vector<GLuint> order(2 * (curve_segments + 1));
  std::iota(order.begin(), order.end(), 0u);
  send(gl, elements_, order, GL_STATIC_DRAW);
  gl.VertexArrayElementBuffer(array_.id(), elements_.id());
}

void CurvesPass::send_strips(const Gl& gl, const std::vector<FurCurves>& curves) {
  if (curves == sent_) return;
  strips_ = make_strips(curves);
  send(gl, points_, strips_.points, GL_STATIC_DRAW);
  send(gl, styles_, strips_.styles, GL_STATIC_DRAW);
  sent_ = curves;
}

CurveOrder CurvesPass::bind(const Gl& gl, const FurFrame& frame, glm::vec3 viewpoint) {
  assert(!frame.curves.empty());
  if (!array_) make_buffers(gl);
  send_strips(gl, frame.curves);
  CurveOrder order = order_strips(strips_, viewpoint);
  send(gl, numbers_, order.curves, GL_STREAM_DRAW);
  gl.BindVertexArray(array_.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, curve_points_storage, points_.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, curve_styles_storage, styles_.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, curve_numbers_storage, numbers_.id());
  return order;
}

void CurvesPass::draw(const Gl& gl, const FurFrame& frame, const std::string& variant) {
  const CurveOrder order = bind(gl, frame, frame.camera.position);
  const Program& program = program_of(gl, variant);
  program.use();
  program.set("segments", curve_segments);
  if (frame.knobs.order == FragmentOrder::sorted) {
    draw_unordered(gl, program, curve_segments, order.curves.size());
  } else {
    draw_four_passes(gl, program, curve_segments, order.back_facing, order.curves.size());
  }
}

void CurvesPass::draw_plain(const Gl& gl, const FurFrame& frame, const std::string& variant) {
  const CurveOrder order = bind(gl, frame, frame.camera.position);
  draw_all_strips(gl, program_of(gl, variant), curve_segments, order.curves.size());
}

void CurvesPass::draw_shadow(const Gl& gl, const FurFrame& frame, const LightView& light, const RenderTarget& target) {
  const CurveOrder order = bind(gl, frame, light.viewpoint);
  if (!shadow_) {
    shadow_.emplace(gl, shaders::curve_vert, shaders::curve_shadow_frag);
    failure_ += shadow_->log();
  }
  set_draw_state(gl, target);
  clear_target(gl, target, {1, 1, 1, nowhere});
  gl.Disable(GL_DEPTH_TEST);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ZERO, GL_SRC_COLOR);
  gl.BlendEquationSeparate(GL_FUNC_ADD, GL_MIN);
  shadow_->use();
  shadow_->set("axis", glm::vec3(light.axis));
  shadow_->set("offset", light.axis.w);
  draw_all_strips(gl, *shadow_, curve_segments, order.curves.size());
  gl.BlendEquation(GL_FUNC_ADD);
  gl.Disable(GL_BLEND);
}

}  // namespace pelage
