#include "renderer/passes/curves/curves_pass.h"

#include <cassert>
#include <numeric>

#include "renderer/passes/draw/strips.h"

namespace pelage {

namespace shaders {
extern const char* const curve_vert;
extern const char* const curve_frag;
}  // namespace shaders

namespace {

constexpr GLuint points_binding = 4, styles_binding = 5, numbers_binding = 6;  // as curve.vert

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

void CurvesPass::draw(const Gl& gl, const FurFrame& frame, const std::string& variant) {
  assert(!frame.curves.empty());
  if (!array_) make_buffers(gl);
  send_strips(gl, frame.curves);
  const CurveOrder order = order_strips(strips_, frame.camera.eye);
  send(gl, numbers_, order.curves, GL_STREAM_DRAW);
  gl.BindVertexArray(array_.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, points_binding, points_.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, styles_binding, styles_.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, numbers_binding, numbers_.id());
  const Program& program = program_of(gl, variant);
  program.use();
  program.set("segments", curve_segments);
  if (frame.knobs.order == FragmentOrder::sorted) {
    draw_unordered(gl, program, curve_segments, order.curves.size());
  } else {
    draw_four_passes(gl, program, curve_segments, order.averted, order.curves.size());
  }
}

}  // namespace pelage
