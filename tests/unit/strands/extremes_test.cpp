// The rows of science.md 7 that concern strands: what is traced is finite, or refused with a reason.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/unit/strands/traced_ball.h"

namespace pelage {
namespace {

constexpr std::array all_aovs{Aov::beauty,  Aov::alpha,  Aov::depth,  Aov::position, Aov::normal,
                              Aov::tangent, Aov::albedo, Aov::direct, Aov::shadow,   Aov::sample_count};
constexpr std::array both{Transport::transmittance, Transport::paths};
constexpr float infinity = std::numeric_limits<float>::infinity();

void expect_sane(const Tracer& tracer) {
  for (const Aov aov : all_aovs) {
    const FloatImage image = tracer.aov(aov);
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
      const float value = image.rgba[i];
      const bool light = aov == Aov::beauty || aov == Aov::direct || aov == Aov::albedo;
      ASSERT_TRUE(std::isfinite(value)) << "AOV " << int(aov);
      ASSERT_TRUE(value >= 0 || !(light || i % 4 == 3)) << "AOV " << int(aov) << ": " << value;
      ASSERT_TRUE(value <= 1 || i % 4 != 3) << "AOV " << int(aov) << ": " << value;
    }
  }
}

/// One tracer for all pictures of a test, as in a server.
class Extremes : public ::testing::Test {
 protected:
  static FurFrame usual(Transport transport) {
    FurFrame frame = frame_at(12, coat_of(glm::vec3(0.5f), 300), transport, 2);
    frame.lights = {light_from({1, -1, -1}, 1)};
    frame.ground = FurGround{.height = -0.3f, .shadow = 0.7f, .contact = 0.7f};
    return frame;
  }
  TraceReport trace(const FurPatch& fur, const FurFrame& frame) {
    const Status begun = tracer_.begin(fur.model(), fur.fields(), frame, nothing(), all_aovs, always);
    EXPECT_TRUE(begun.ok()) << begun.message;
    while (begun.ok() && tracer_.report().end == TraceEnd::none) EXPECT_TRUE(tracer_.add_pass(always).ok());
    if (begun.ok()) expect_sane(tracer_);
    return tracer_.report();
  }
  TraceReport trace(const FurFrame& frame) { return trace(ball_, frame); }

  FurPatch ball_ = fur_ball(0.05f);
  Tracer tracer_{2, plenty, false};
};

TEST_F(Extremes, FoldedFieldsGiveSanePictures) {
  for (const Transport transport : both) {
    FurPatch fur = ball_;
    for (std::size_t i = 0; i < fur.direction.size(); ++i) {
      const float turn = 2.4f * static_cast<float>(i);
      fur.direction[i] = i % 3 == 0 ? glm::vec2(0) : glm::vec2(std::cos(turn), std::sin(turn));
      fur.length[i] = i % 5 == 0 ? 10.0f : i % 5 == 1 ? 1e-6f : 0.05f;
    }
    EXPECT_GT(trace(fur, usual(transport)).strands, 0u);
    fur.id = 2;
    for (std::size_t i = 0; i < fur.normals.size(); ++i) {
      fur.normals[i] = i % 2 ? fur.normals[i] : -fur.normals[i];  // folds the skin too
      if (i % 7 == 0) fur.tangents[i] = fur.normals[i];
    }
    trace(fur, usual(transport));
    fur.id = 3;
    for (glm::vec3& position : fur.positions) position.y = 0;
    trace(fur, usual(transport));
    fur.id = 4;
    for (glm::vec3& position : fur.positions) position = glm::vec3(0.1f);
    trace(fur, usual(transport));
  }
}

TEST_F(Extremes, AnyLengthDensityAndCountGivesSanePictures) {
  for (const Transport transport : both) {
    for (const float length : {0.0f, 1e-6f, 10.0f}) trace(fur_ball(length), usual(transport));
    const std::vector<float> none(ball_.positions.size(), 0.0f), whole(ball_.positions.size(), 1.0f);
    FurPatch fur = ball_;
    fur.paint.density = none;
    EXPECT_EQ(trace(fur, usual(transport)).strands, 0u);
    fur.paint.density = fur.paint.curl = fur.paint.clump = fur.paint.wetness = whole, fur.paint.width = none;
    EXPECT_GT(trace(fur, usual(transport)).strands, 0u);
    fur.paint.bare = whole;
    EXPECT_EQ(trace(fur, usual(transport)).strands, 0u);
    FurFrame one = usual(transport);
    one.coat().count = 1, one.coat().tile = 1;
    EXPECT_LT(trace(one).strands, 8u);
    FurPatch nowhere;
    nowhere.id = 2;
    EXPECT_EQ(trace(nowhere, one).strands, 0u);
  }
}

TEST_F(Extremes, AnyWidthFormAndWetnessGivesSanePictures) {
  for (const Transport transport : both) {
    FurFrame frame = usual(transport);
    for (const double width : {0.0, 0.05}) {
      frame.coat().width_root = frame.coat().width_tip = width;
      EXPECT_GT(trace(frame).strands, 0u);
    }
    frame = usual(transport);
    frame.coat().curl = frame.coat().wave = 0.5, frame.coat().curl_turns = frame.coat().wave_turns = 20;
    frame.coat().bend = 2, frame.coat().mess = frame.coat().clump = frame.coat().fine_clump = frame.coat().lodge = 1;
    frame.coat().length_spread = frame.coat().colour_spread = frame.coat().root_share = frame.coat().wetness = 1;
    frame.coat().tufts.gather = 1, frame.coat().tufts.scales = 3;
    for (const double self_shadow : {0.0, 4.0}) {
      frame.look.self_shadow = self_shadow;
      trace(frame);
    }
  }
}

TEST_F(Extremes, DenseFurIsThinnedOutToWhatIsAllowed) {
  FurFrame frame = usual(Transport::transmittance);
  frame.coat().count = 100'000, frame.coat().tile = 0.01;  // 800 million strands
  for (const int allowed : {1, 10'000}) {
    frame.knobs.trace.strands = allowed;
    const std::size_t strands = trace(frame).strands;
    EXPECT_LE(strands, static_cast<std::size_t>(allowed) * 3 / 2 + 8);
    EXPECT_GE(strands, static_cast<std::size_t>(allowed) / 4);
  }
}

FurLight point_at(glm::vec3 position, float radiance) {
  FurLight light;
  light.kind = LightKind::point, light.position = position, light.radiance = glm::vec3(radiance), light.radius = 0.01f;
  return light;
}

TEST_F(Extremes, LightsAnywhereGiveSanePictures) {
  const StrandSet strands = ball_.grow({usual(Transport::paths).coat()});
  for (const Transport transport : both) {
    FurFrame frame = usual(transport);
    for (const glm::vec3 position : {knot(strands, 5, 0).position, knot(strands, 5, 3).position, glm::vec3(0),
                                     glm::vec3(0, 0, 0.25f), glm::vec3(0, 1e6f, 0), glm::vec3(0, 1e30f, 0)}) {
      for (const float radiance : {0.0f, 1.0f, 1e8f}) {
        frame.lights = {point_at(position, radiance)};
        for (const float radius : {0.0f, 10.0f}) {
          frame.lights.front().radius = radius;
          trace(frame);
        }
        frame.lights.front().kind = LightKind::spot;
        trace(frame);
        frame.lights.front().kind = LightKind::area;
        for (const float side : {1e-3f, 100.0f}) {
          frame.lights.front().extent = glm::vec2(side);
          trace(frame);
        }
      }
    }
  }
}

TEST_F(Extremes, DirectionalAndEnvironmentLightGivesSanePictures) {
  for (const Transport transport : both) {
    FurFrame frame = usual(transport);
    for (const float angle : {0.0f, 1.5707964f}) {
      for (const float radiance : {0.0f, 1e8f}) {
        frame.lights = {light_from({0, -1, 0}, radiance), light_from({0, 1, 0}, 1), light_from({0, 0, -1}, 1)};
        for (FurLight& light : frame.lights) light.angle = angle;
        trace(frame);
      }
    }
    for (const double intensity : {0.0, 100.0}) {
      frame.environment = {};
      frame.environment.intensity = intensity;
      frame.look.ambient = intensity == 0 ? 0 : 4;
      trace(frame);
      frame.environment.sky = frame.environment.horizon = frame.environment.ground = glm::vec3(0);
      trace(frame);
      SphericalHarmonics lobes{};
      lobes.fill(glm::dvec3(-1e6, 1e6, 1));
      for (const double constant : {-1e6, 0.0, 1e6}) {
        lobes.front() = glm::dvec3(constant);
        frame.environment.harmonics = lobes;
        trace(frame);
      }
    }
  }
}

TEST_F(Extremes, CamerasAnywhereGiveSanePictures) {
  const StrandSet strands = ball_.grow({usual(Transport::paths).coat()});
  const glm::vec3 along = glm::normalize(tip(strands, 5).position - knot(strands, 5, 0).position);
  const auto looking = [](FurFrame frame, glm::vec3 position, glm::vec3 forward) {
    frame.camera.position = position, frame.camera.forward = glm::normalize(forward);
    const glm::vec3 up = std::abs(frame.camera.forward.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    frame.camera.right = glm::normalize(glm::cross(frame.camera.forward, up));
    frame.camera.up = glm::cross(frame.camera.right, frame.camera.forward);
    return frame;
  };
  for (const Transport transport : both) {
    for (const float tan_half_fov : {0.0087f, 3.73f}) {  // 1 and 150 degrees
      FurFrame frame = usual(transport);
      frame.camera.tan_half_fov = tan_half_fov;
      trace(looking(frame, {0, 0, 0.27f}, {0, 0, -1}));            // inside the fur
      trace(looking(frame, {0, 0, 0.25f}, {0, 0, -1}));            // on the skin
      trace(looking(frame, {0, 0, 0.25f}, {1, 0, 0}));             // along the skin
      trace(looking(frame, {0, 0, 0}, {0, 0, -1}));                // inside the body
      trace(looking(frame, knot(strands, 5, 0).position, along));  // inside a strand
      trace(looking(frame, tip(strands, 5).position + along, -along));
      trace(looking(frame, {0, 0, 1e6f}, {0, 0, -1}));
      trace(looking(frame, {0, -1e6f, 0}, {0, 1, 0}));
      trace(looking(frame, {0, 1e20f, 1e20f}, {0, -1, -1}));  // beyond Embree's range
      trace(looking(frame, {1e37f, 0, 0}, {-1, 0, 0}));
    }
  }
}

TEST_F(Extremes, PicturesOfAnySizeAreTraced) {
  FurFrame frame = usual(Transport::transmittance);
  frame.knobs.trace.passes = 1, frame.knobs.trace.filter = true;
  for (const glm::ivec2 size : {glm::ivec2(1, 1), {1, 8192}, {8192, 1}, {17, 15}}) {
    frame.width = size.x, frame.height = size.y;
    EXPECT_EQ(trace(frame).samples, 1);
  }
}

TEST_F(Extremes, EveryScatteringModelGivesSanePictures) {
  const std::vector<float> wet(ball_.positions.size(), 1.0f);
  FurPatch fur = ball_;
  for (const ShadingModel model : {ShadingModel::lengyel, ShadingModel::kajiya, ShadingModel::energy_conserving,
                                   ShadingModel::scheuermann, ShadingModel::kajiya_kay, ShadingModel::marschner}) {
    FurFrame frame = usual(Transport::transmittance);
    frame.knobs.trace.scattering = StrandScattering::look;
    frame.look.shading = model;
    trace(fur, frame);
    fur.paint.wetness = wet, frame.coat().wetness = 1;
    frame.look.specular_exponent = frame.look.fibre.secondary_exponent = frame.look.diffuse_exponent = 1e6;
    frame.look.ambient = frame.look.diffuse = frame.look.specular = 4;
    frame.look.fibre.primary_shift = 2, frame.look.fibre.secondary_shift = -2, frame.look.fibre.shift_spread = 2;
    frame.look.fibre.highlight_width = 0, frame.look.fibre.caustic_width = 1, frame.look.fibre.cuticle_tilt = 15;
    for (const double index : {1.0, 1 + 1e-6, 3.0}) {
      frame.look.fibre.refractive_index = index;
      frame.look.fibre.absorption = Absorption::melanin;
      frame.look.fibre.eumelanin = frame.look.fibre.pheomelanin = index == 1 ? 0 : 1e4;
      trace(fur, frame);
    }
    fur.paint.wetness = {};
  }
}

TEST_F(Extremes, EyesWhiskersAndBareSkinMayOverlap) {
  FurFrame frame = usual(Transport::transmittance);
  frame.eyes.resize(4);
  frame.eyes[1].radius = 1e6f, frame.eyes[2].radius = 1e-6f;  // one around everything, and a tiny one
  frame.eyes[3].position = glm::vec3(1e30f);
  FurGuide whisker{.points = {{0, 0, 0}, {0, 0, 0.2}, {0, 0, 0.2}, {0, 0, 0.6}}};
  FurGuide dot{.points = {{0, 0, 0.3}, {0, 0, 0.3}}};
  frame.curves = {{.guides = {whisker, dot}, .width_root = 0.05, .width_tip = 0, .fill = 3, .spread = 1}};
  FurSkinRegion bare;
  bare.to_unit = glm::dmat3(4), bare.centre = {0, 0, 0.25};
  frame.skin = {bare, bare};
  FurPatch fur = ball_;
  fur.skin = frame.skin;
  for (const Transport transport : both) {
    frame.knobs.trace.transport = transport;
    EXPECT_GT(trace(fur, frame).strands, 0u);
    frame.eyes.resize(1);
    trace(fur, frame);
    frame.eyes.resize(3), frame.eyes[1].radius = 1e6f, frame.eyes[2].radius = 1e-6f;
  }
}

TEST_F(Extremes, AnyBackplateGivesSanePictures) {
  for (const float value : {-1.0f, 0.0f, 1.0f, 1e30f, infinity, std::numeric_limits<float>::quiet_NaN()}) {
    const FloatImage any{.width = 1, .height = 1, .rgba = {value, value, value, 1}};
    for (const Transport transport : both) {
      const FurPatch bald = fur_ball(0);
      const FurFrame frame = usual(transport);
      ASSERT_TRUE(tracer_.begin(bald.model(), bald.fields(), frame, {any, any, any, any, any}, all_aovs, always).ok());
      ASSERT_TRUE(tracer_.add_pass(always).ok());
      expect_sane(tracer_);
    }
  }
}

TEST_F(Extremes, ReportsWhyATraceEnded) {
  FurFrame frame = usual(Transport::transmittance);
  frame.knobs.trace.passes = 65536, frame.knobs.trace.seconds = 0.01;
  const TraceReport brief = trace(frame);
  EXPECT_EQ(brief.end, TraceEnd::seconds);
  EXPECT_GE(brief.passes, 1);
  frame.knobs.trace.seconds = 0, frame.knobs.trace.noise = 1;
  EXPECT_EQ(trace(frame).end, TraceEnd::noise);
  frame.knobs.trace.noise = 0;
  for (const std::uint32_t seed : {0u, 4294967295u}) {
    frame.knobs.trace.seed = seed, frame.knobs.trace.passes = 2;
    EXPECT_EQ(trace(frame).end, TraceEnd::passes);
  }
  frame.knobs.trace.transport = Transport::paths;
  for (const int bounces : {1, 4096}) {
    frame.knobs.trace.bounces = bounces;
    trace(frame);
  }
  frame.exposure = 20, frame.knobs.trace.noise = 1e-9;
  trace(frame);
  frame.exposure = -20;
  trace(frame);
}

}  // namespace
}  // namespace pelage
