// With any combination of settings, a small ball is traced to a finite picture, to the same picture twice, and its
// report is consistent.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/unit/strands/traced_ball.h"

namespace pelage {
namespace {

template <class T>
T one_of(std::vector<T> values) {
  return *rc::gen::elementOf(std::move(values));
}

glm::vec3 any_position() {
  const auto number = [] { return one_of<float>({0, 0.1f, -0.25f, 0.26f, 0.7f, -3, 1e6f, 1e30f}); };
  return {number(), number(), number()};
}

FurLight any_light() {
  FurLight light;
  light.kind = one_of<LightKind>({LightKind::directional, LightKind::point, LightKind::spot, LightKind::area});
  const glm::vec3 position = any_position(), direction = glm::min(any_position(), 1e6f);
  light.position = position;
  light.direction = glm::length(direction) > 0 ? glm::normalize(direction) : glm::vec3(0, -1, 0);
  light.radiance = glm::vec3(1, 0.5f, 0) * one_of<float>({0, 1e-3f, 1, 1e8f});
  light.cone = one_of<float>({0, 0.5f, 1}), light.soft_cone = one_of<float>({0, 0.7f, 1});
  light.angle = one_of<float>({0, 0.05f, 1.5707964f}), light.radius = one_of<float>({0, 0.05f, 10});
  light.extent = {one_of<float>({1e-3f, 0.5f, 100}), one_of<float>({1e-3f, 0.5f, 100})};
  return light;
}

Coat any_coat() {
  Coat coat = coat_of({one_of<float>({0, 0.5f, 1}), 0.3f, one_of<float>({0, 1})}, one_of<int>({1, 20, 60}));
  const auto share = [] { return one_of<double>({0, 0.3, 1}); };
  coat.width_root = one_of<double>({0, 0.001, 0.05}), coat.width_tip = one_of<double>({0, 0.001, 0.05});
  coat.bend = one_of<double>({0, 0.25, 2});
  coat.curl = one_of<double>({0, 0, 0.1, 0.5}), coat.wave = one_of<double>({0, 0, 0.1, 0.5});
  coat.clump = share(), coat.mess = share(), coat.lodge = share(), coat.wetness = share();
  coat.length_spread = share(), coat.colour_spread = share(), coat.root_share = share();
  coat.tufts.gather = share();
  return coat;
}

FurFrame any_frame() {
  FurFrame frame = frame_at(1, any_coat(), one_of<Transport>({Transport::transmittance, Transport::paths}), 1);
  frame.width = one_of<int>({1, 7, 12}), frame.height = one_of<int>({1, 5, 10});
  frame.camera.position = any_position();
  frame.camera.tan_half_fov = one_of<float>({0.0087f, 0.2f, 3.73f});
  for (int i = one_of<int>({0, 1, 3}); i > 0; --i) frame.lights.push_back(any_light());
  frame.environment.intensity = one_of<double>({0, 1, 100});
  frame.environment.ground = glm::vec3(one_of<float>({0, 1}));
  if (one_of<int>({0, 1}) == 1) frame.ground = FurGround{one_of<float>({-0.3f, 0, 0.5f}), 1, 1};
  Tracing& trace = frame.knobs.trace;
  trace.passes = one_of<int>({1, 2}), trace.bounces = one_of<int>({1, 8, 4096}),
  trace.filter = one_of<int>({0, 1}) == 1;
  trace.strands = one_of<int>({1, 500, 8'000'000}), trace.noise = one_of<double>({0, 0.01, 1});
  trace.seed = one_of<std::uint32_t>({0, 1, 4294967295u});
  if (trace.transport == Transport::transmittance) {  // paths take only energy_conserving
    trace.scattering = one_of<StrandScattering>({StrandScattering::look, StrandScattering::energy_conserving});
  }
  frame.look.shading =
      one_of<ShadingModel>({ShadingModel::lengyel, ShadingModel::kajiya, ShadingModel::energy_conserving,
                            ShadingModel::scheuermann, ShadingModel::marschner});
  frame.look.fibre.longitudinal_roughness = one_of<double>({0, 0.3, 1});
  frame.look.fibre.azimuthal_roughness = one_of<double>({0, 0.3, 1});
  frame.look.fibre.refractive_index = one_of<double>({1, 1.55, 3});
  frame.look.self_shadow = one_of<double>({0, 1, 4}), frame.look.ambient = one_of<double>({0, 0.4, 4});
  return frame;
}

FurPatch any_ball() {
  FurPatch ball = fur_ball(0);
  const float length = one_of<float>({0, 1e-6f, 0.03f, 0.5f, 10}), mixed = one_of<float>({0, 1});
  for (std::size_t i = 0; i < ball.length.size(); ++i) {
    const auto turn = static_cast<float>(i);
    ball.direction[i] += mixed * glm::vec2(std::cos(turn), std::sin(turn));
    ball.length[i] = i % 3 == 0 && mixed > 0 ? 0.01f : length;
  }
  return ball;
}

FloatImage traced_by(Tracer& tracer, const FurPatch& ball, const FurFrame& frame) {
  const Status begun = tracer.begin(ball.model(), ball.fields(), frame, nothing(), std::array{Aov::beauty}, always);
  RC_ASSERT(begun.ok());
  while (tracer.report().end == TraceEnd::none) RC_ASSERT(tracer.add_pass(always).ok());
  return tracer.aov(Aov::beauty);
}

RC_GTEST_PROP(AnyScene, IsFiniteTheSameTwiceAndReported, ()) {
  static Tracer tracer(2, plenty, false);  // one tracer for all cases, like a server's
  const FurPatch ball = any_ball();
  const FurFrame frame = any_frame();
  const FloatImage picture = traced_by(tracer, ball, frame);
  for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
    const float value = picture.rgba[i];
    RC_ASSERT(std::isfinite(value) && value >= 0);
    RC_ASSERT(i % 4 != 3 || value <= 1);
  }
  const TraceReport report = tracer.report();
  RC_ASSERT(report.passes >= 1 && report.passes <= frame.knobs.trace.passes);
  RC_ASSERT(report.samples >= 1 && report.samples <= report.passes);
  RC_ASSERT(report.noise >= 0);
  RC_ASSERT(report.strands <= std::size_t(frame.knobs.trace.strands) * 2 + 20);
  FurFrame other = frame;
  other.coat().count += 7, other.camera.position.z += 0.5f, other.knobs.trace.passes = 1;
  traced_by(tracer, ball, other);
  RC_ASSERT(traced_by(tracer, ball, frame).rgba == picture.rgba);
}

}  // namespace
}  // namespace pelage
