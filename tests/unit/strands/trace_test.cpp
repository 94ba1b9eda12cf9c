// Whole traced pictures of small scenes: energy, bias, lights and extremes.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "renderer/image/cropped.h"
#include "tests/unit/strands/traced_ball.h"

namespace pelage {
namespace {

// science.md 4: energy is conserved, so the ball cannot be distinguished from the room.
TEST(TraceFurnace, AWhiteFurBallInAWhiteRoomVanishes) {
  FurFrame frame = frame_at(40, coat_of(glm::vec3(1)), Transport::paths, 64);
  frame.knobs.trace.bounces = 4096;
  frame.look.fibre.cuticle_tilt = 0;
  const Mean mean = mean_of(traced(fur_ball(0.04f), frame).beauty);
  EXPECT_GT(mean.alpha, 400);
  EXPECT_NEAR(mean.red / mean.alpha, 1, 0.01);
}

TEST(TraceFurnace, FewBouncesLoseLight) {
  FurFrame frame = frame_at(24, coat_of(glm::vec3(1)), Transport::paths, 16);
  frame.knobs.trace.bounces = 2;
  const Mean mean = mean_of(traced(fur_ball(0.04f), frame).beauty);
  EXPECT_LT(mean.red / mean.alpha, 0.97);
}

TEST(Trace, TheSameSeedGivesTheSameBitsAtAnyThreadCount) {
  const FurPatch ball = fur_ball(0.03f);
  for (const Transport transport : {Transport::transmittance, Transport::paths}) {
    FurFrame frame = frame_at(40, coat_of({0.5f, 0.3f, 0.2f}), transport, 2);
    frame.lights = {light_from({1, -1, -1}, 1)};
    const Traced one = traced(ball, frame, 1), four = traced(ball, frame, 4);
    EXPECT_EQ(one.beauty.rgba, four.beauty.rgba);
    frame.knobs.trace.seed = 2;
    EXPECT_NE(traced(ball, frame, 4).beauty.rgba, one.beauty.rgba);
  }
}

TEST(Trace, ACropHasTheBitsOfTheWhole) {
  const FurPatch ball = fur_ball(0.03f);
  for (const bool filter : {false, true}) {
    FurFrame frame = frame_at(90, coat_of({0.5f, 0.3f, 0.2f}, 300), Transport::transmittance, 24);
    frame.lights = {light_from({1, -1, -1}, 1)};
    frame.knobs.trace.filter = filter;
    frame.knobs.trace.noise = 0.02;  // some tiles end early
    const Traced whole = traced(ball, frame);
    for (const Crop& crop : {Crop{0, 0, 40, 90}, Crop{33, 21, 30, 19}, Crop{45, 45, 1, 1}}) {
      frame.crop = crop;
      const Traced part = traced(ball, frame);
      EXPECT_LE(part.report.passes, whole.report.passes);
      EXPECT_TRUE(std::isfinite(part.report.noise) && part.report.samples > 0);
      const auto pixels = [&](const FloatImage& image) {
        return cropped(image, crop.left, crop.top, crop.width, crop.height).rgba;
      };
      EXPECT_TRUE(pixels(part.beauty) == pixels(whole.beauty)) << filter << " " << crop.left;
    }
  }
}

/// Pictures of a few passes with different seeds. The scene is grown once.
std::vector<FloatImage> pictures(const FurPatch& fur, FurFrame frame, int passes, std::uint32_t count) {
  std::vector<FloatImage> result;
  Tracer tracer(2, plenty, false);
  frame.knobs.trace.passes = passes;
  for (frame.knobs.trace.seed = 11; frame.knobs.trace.seed < 11 + count; ++frame.knobs.trace.seed) {
    EXPECT_TRUE(tracer.begin(fur.model(), fur.fields(), frame, nothing(), std::array{Aov::beauty}, always).ok());
    while (tracer.report().end == TraceEnd::none) EXPECT_TRUE(tracer.add_pass(always).ok());
    result.push_back(tracer.aov(Aov::beauty));
  }
  return result;
}

TEST(Trace, PassesBringNoBiasAndLessNoise) {
  const FurPatch ball = fur_ball(0.03f);
  FurFrame frame = frame_at(32, coat_of({0.5f, 0.3f, 0.2f}, 300), Transport::transmittance, 1);
  frame.lights = {light_from({1, -1, -1}, 1)};
  const FloatImage truth = pictures(ball, frame, 512, 1).front();
  std::vector<double> errors;
  for (const int passes : {1, 4, 16}) {
    double square = 0, sum = 0, sum_square = 0;
    const auto few = pictures(ball, frame, passes, 32);
    for (const FloatImage& picture : few) {
      for (std::size_t i = 0; i < picture.rgba.size(); i += 4) square += std::pow(picture.rgba[i] - truth.rgba[i], 2);
      const double red = mean_of(picture).red;
      sum += red / 32, sum_square += red * red / 32;
    }
    errors.push_back(std::sqrt(square / 32));
    const double deviation = std::sqrt(std::max(sum_square - sum * sum, 0.0) / 32);
    EXPECT_NEAR(sum, mean_of(truth).red, 4 * deviation) << passes;
    EXPECT_LT(deviation, 0.02 * sum);
  }
  EXPECT_LT(errors[1], 0.55 * errors[0]);  // a half by samples^-0.5
  EXPECT_LT(errors[2], 0.55 * errors[1]);
}

TEST(Trace, LightsAddUp) {
  const FurPatch ball = fur_ball(0.03f);
  for (const Transport transport : {Transport::transmittance, Transport::paths}) {
    FurFrame frame = frame_at(24, coat_of({0.5f, 0.3f, 0.2f}), transport, 96);
    const FurLight key = light_from({1, -1, -1}, 1), rim = light_from({-0.5f, -0.2f, 1}, 2);
    const auto red = [&](std::vector<FurLight> lights, double ambient) {
      frame.lights = std::move(lights), frame.look.ambient = ambient;
      return mean_of(traced(ball, frame).beauty).red;
    };
    const double parts = red({key}, 0) + red({rim}, 0) + red({}, 1);
    EXPECT_NEAR(red({key, rim}, 1), parts, 0.02 * parts);
  }
}

TEST(Trace, PaleFurTransmitsLightAndDarkFurDoesNot) {
  const FurPatch ball = fur_ball(0.05f);
  const auto from_behind = [&](float colour) {
    FurFrame frame = frame_at(32, coat_of(glm::vec3(colour), 4000), Transport::transmittance, 16);
    frame.lights = {light_from({0, 0, 1}, 1)};
    frame.look.ambient = frame.look.specular = 0;
    frame.look.shading = ShadingModel::scheuermann, frame.look.fibre.secondary_specular = 0;
    frame.knobs.trace.scattering = StrandScattering::look;
    return mean_of(traced(ball, frame).beauty).red / colour;
  };
  EXPECT_GT(from_behind(0.9f), 1.5 * from_behind(0.05f));
}

TEST(Trace, GroundDarkensWhereTheBodyStands) {
  FurFrame frame = frame_at(48, coat_of(glm::vec3(0.5f)), Transport::transmittance, 16);
  frame.ground = FurGround{.height = -0.28f, .shadow = 0.7f, .contact = 0.7f};
  frame.camera.position = {0, 0.4f, 2}, frame.camera.forward = glm::normalize(glm::vec3(0, -0.2f, -1));
  frame.camera.up = glm::normalize(glm::vec3(0, 1, -0.2f));
  frame.lights = {light_from({0.5f, -1, 0}, 1)};
  const FloatImage picture = traced(fur_ball(0.03f), frame).beauty;
  double shade = 0;
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
    if (picture.rgba[i] == 0) shade += picture.rgba[i + 3];
    EXPECT_LE(picture.rgba[i + 3], 1.0f);
  }
  EXPECT_GT(shade, 20);
  frame.ground->shadow = frame.ground->contact = 0;
  double lit = 0;
  const FloatImage without_shadow = traced(fur_ball(0.03f), frame).beauty;
  for (std::size_t i = 0; i < without_shadow.rgba.size(); i += 4) {
    if (without_shadow.rgba[i] == 0) lit += without_shadow.rgba[i + 3];
  }
  EXPECT_LT(lit, 0.05 * shade);  // the rest are strands that no light has reached
}

// Strands much wider than the fur is high would stick out of it into the light.
TEST(Trace, ShortFurKeepsItsStrandsFromAfar) {
  const auto share_from_afar = [](float length) {
    const FurPatch ball = fur_ball(length);
    FurFrame frame = frame_at(8, coat_of(glm::vec3(0.5f)), Transport::transmittance, 1);
    frame.coat().width_root = 0.0004, frame.coat().width_tip = 0.0001;
    const auto strands = [&] { return static_cast<double>(traced(ball, frame).report.strands); };
    const double far = strands();
    frame.camera.tan_half_fov *= 0.004f, frame.knobs.trace.strands = 8'000'000;
    return far / static_cast<double>(traced(ball, frame).report.strands);
  };
  EXPECT_EQ(share_from_afar(0.02f), 1);
  EXPECT_LT(share_from_afar(0.2f), 0.3);
}

TEST(Trace, EndsAtALevelOfNoise) {
  FurFrame frame = frame_at(48, coat_of(glm::vec3(0.5f)), Transport::transmittance, 4096);
  frame.lights = {light_from({1, -1, -1}, 1)};
  frame.knobs.trace.noise = 0.02;
  const Traced picture = traced(fur_ball(0.03f), frame);
  EXPECT_EQ(picture.report.end, TraceEnd::noise);
  EXPECT_LE(picture.report.noise, 0.02);
  EXPECT_GE(picture.report.passes, 8);
  EXPECT_LT(picture.report.samples, picture.report.passes);  // empty tiles take fewer samples
}

// The extremes of science.md 7.
TEST(TraceExtremes, FiniteForAnyScene) {
  const FurPatch ball = fur_ball(0.05f);
  for (const Transport transport : {Transport::transmittance, Transport::paths}) {
    const FurFrame usual = frame_at(12, coat_of(glm::vec3(0.5f), 400), transport, 2);
    const auto looks_finite = [&](const FurPatch& fur, const FurFrame& frame) {
      expect_finite(traced(fur, frame).beauty);
    };
    looks_finite(fur_ball(0), usual);
    looks_finite(fur_ball(10), usual);
    for (const double width : {0.0, 0.05}) {
      FurFrame frame = usual;
      frame.coat().width_root = frame.coat().width_tip = width;
      looks_finite(ball, frame);
    }
    FurFrame one = usual;
    one.coat().count = 1;
    looks_finite(ball, one);
    for (const float distance : {0.251f, 0.27f, 0.0f, 1e6f}) {  // inside the fur, inside the body, far away
      FurFrame frame = usual;
      FurLight light;
      light.kind = LightKind::point, light.position = {0, 0, distance}, light.radiance = glm::vec3(1e8f),
      light.radius = 0.01f;
      frame.lights = {light};
      looks_finite(ball, frame);
      frame.camera.position = {0, 0, distance};
      looks_finite(ball, frame);
    }
    for (const double roughness : {0.0, 1.0}) {
      FurFrame frame = usual;
      frame.look.fibre.longitudinal_roughness = frame.look.fibre.azimuthal_roughness = roughness;
      frame.look.fibre.refractive_index = roughness == 0 ? 1.0 : 3.0;
      frame.coat().ramp = {{0, glm::vec3(static_cast<float>(roughness))}};
      frame.lights = {light_from({0, 0, -1}, 1e8f), light_from({0, 0, 1}, 0)};
      looks_finite(ball, frame);
    }
    FurFrame tiny = usual;
    tiny.width = tiny.height = 1;
    looks_finite(ball, tiny);
  }
}

TEST(TraceExtremes, APictureBeyondTheMemoryIsRefused) {
  FurFrame frame = frame_at(8192, coat_of(glm::vec3(0.5f), 10), Transport::transmittance, 1);
  Tracer tracer(1, std::size_t{256} << 20, false);
  const FurPatch ball = fur_ball(0.03f);
  const Status status = tracer.begin(ball.model(), ball.fields(), frame, nothing(), std::array{Aov::beauty}, always);
  EXPECT_EQ(status.code, Code::too_large);
  EXPECT_EQ(status.pointer, "/width");
}

TEST(TraceExtremes, CancelledAtAnyMomentItBeginsAgain) {
  const FurPatch ball = fur_ball(0.03f);
  const FurFrame frame = frame_at(40, coat_of(glm::vec3(0.5f)), Transport::transmittance, 2);
  const Traced whole = traced(ball, frame);
  Tracer tracer(2, plenty, false);
  for (const int calls : {0, 1, 3, 6, 9, 12}) {
    std::atomic<int> left{calls};
    const auto some = [&left] { return left-- > 0; };
    Status status = tracer.begin(ball.model(), ball.fields(), frame, nothing(), std::array{Aov::beauty}, some);
    while (status.ok() && tracer.report().end == TraceEnd::none) status = tracer.add_pass(some);
    EXPECT_EQ(status.code, Code::unavailable) << calls;
  }
  ASSERT_TRUE(tracer.begin(ball.model(), ball.fields(), frame, nothing(), std::array{Aov::beauty}, always).ok());
  while (tracer.report().end == TraceEnd::none) ASSERT_TRUE(tracer.add_pass(always).ok());
  EXPECT_EQ(tracer.aov(Aov::beauty).rgba, whole.beauty.rgba);
}

}  // namespace
}  // namespace pelage
