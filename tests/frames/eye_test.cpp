// Eyes drawn alone, in linear light.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "renderer/eye/optics.h"
#include "renderer/raster/raster.h"

namespace pelage::testing::eye_test {
namespace {

constexpr int size = 96;

/// A frame whose camera looks along -Z at an eye of radius .1 that looks back.
FurFrame frame_with(FurEye eye) {
  FurFrame frame;
  eye.radius = 0.1f;
  frame.eyes = {eye};
  frame.camera.position = {0, 0, 2};
  frame.camera.tan_half_fov = 0.06f;
  frame.width = frame.height = size;
  frame.background_colour = glm::vec3(0.5f);
  frame.lights = {{.kind = LightKind::directional,
                   .direction = glm::normalize(glm::vec3(-0.5f, -0.6f, -0.6f)),
                   .radiance = glm::vec3(1)}};
  return frame;
}

/// Moves the camera on a circle around the eye, `degrees` to the eye's own left, and points it at the eye.
void look_from(FurFrame& frame, float degrees, float distance = 2) {
  const float angle = glm::radians(degrees);
  const glm::vec3 away(std::sin(angle), 0, std::cos(angle));
  frame.camera = {distance * away, {std::cos(angle), 0, -std::sin(angle)}, {0, 1, 0}, -away, frame.camera.tan_half_fov};
}

class Eyes : public ::testing::Test {
 protected:
  std::vector<glm::vec4> draw(const FurFrame& frame) {
    const FurModel nothing;
    const RasterScene scene = raster.bare_scene_of(nothing, {}, frame, RasterOutput::light);
    FloatImage light;
    light.width = light.height = size;
    light.rgba.resize(4 * size * size);
    RasterCounts counts;
    for (const PixelBox& box : Raster::boxes_of(frame)) raster.draw_box(scene, box, light, counts);
    std::vector<glm::vec4> pixels;
    for (std::size_t i = 0; i < light.rgba.size(); i += 4)
      pixels.emplace_back(light.rgba[i], light.rgba[i + 1], light.rgba[i + 2], light.rgba[i + 3]);
    return pixels;
  }

  Raster raster{2};
};

bool all_finite(const std::vector<glm::vec4>& pixels) {
  for (const glm::vec4& pixel : pixels) {
    for (int k = 0; k < 4; ++k) {
      if (!std::isfinite(pixel[k]) || pixel[k] < 0) return false;
    }
  }
  return true;
}

double alpha_of(const std::vector<glm::vec4>& pixels) {
  double sum = 0;
  for (const glm::vec4& pixel : pixels) sum += pixel.a;
  return sum;
}

TEST_F(Eyes, CoverTheDiscOfTheBall) {
  FurEye eye;
  eye.bulge = 0;
  const std::vector<glm::vec4> pixels = draw(frame_with(eye));
  // A ball of radius r at distance d fills a circle whose tangent is r / sqrt(d^2 - r^2).
  const double radius = 0.1 / std::sqrt(4 - 0.01) / 0.06 * size / 2;
  EXPECT_NEAR(alpha_of(pixels), 3.14159265 * radius * radius, 0.005 * 3.14159265 * radius * radius);
  EXPECT_EQ(pixels[size / 2 * size + size / 2].a, 1);
}

TEST_F(Eyes, ExtremesStayFinite) {
  for (const double refraction : {1.0, 1.376, 3.0}) {
    for (const double depth : {0.0, 0.5}) {
      for (const std::optional<double> pupil : {std::optional(0.0), std::optional(1.0), std::optional<double>()}) {
        for (const int steps : {0, 1, 2, 64}) {
          FurEye eye;
          eye.refraction = refraction, eye.bulge = depth * 2, eye.wetness = depth * 2;
          eye.iris.depth = depth, eye.iris.relief = 0.2, eye.iris.size = depth > 0 ? 0.95 : 0.1;
          eye.pupil = {steps % 2 ? PupilShape::slit : PupilShape::round, pupil};
          if (steps == 2) eye.lids = FurLids{glm::mat3(1), {1.5f, 1.5f, 1.5f}, glm::vec3(0)};
          FurFrame frame = frame_with(eye);
          frame.knobs.eye_steps = steps;
          frame.lights.push_back({.kind = LightKind::point, .position = {0, 0, 0.1f}, .radiance = glm::vec3(1e8f)});
          for (const float degrees : {0.f, 89.9f, 90.f, 180.f}) {
            look_from(frame, degrees);
            ASSERT_TRUE(all_finite(draw(frame))) << refraction << " " << depth << " " << steps << " " << degrees;
          }
        }
      }
    }
  }
}

TEST_F(Eyes, BehindTheCameraOrAroundItNothingIsDrawn) {
  FurFrame frame = frame_with({});
  frame.camera.position = {0, 0, -1};  // behind the eye, and looks away from it
  EXPECT_EQ(alpha_of(draw(frame)), 0);
  for (const float z : {0.f, 0.05f, 0.099f}) {
    frame.camera.position = {0, 0, z};
    const auto pixels = draw(frame);
    EXPECT_TRUE(all_finite(pixels));
    EXPECT_EQ(alpha_of(pixels), 0) << z;
  }
  frame.camera.position = {0, 0, 0.2f};  // close by
  EXPECT_GT(alpha_of(draw(frame)), 0.99 * size * size);
  frame.camera.position = {0, 0, 1e6f};
  EXPECT_TRUE(all_finite(draw(frame)));
}

/// Traces the ray of a pixel in double. Returns whether it ends inside the pupil; nothing off the cornea and near
/// edges.
std::optional<bool> sees_pupil(const FurFrame& frame, int x, int y) {
  const EyeShape shape = shape_of(frame.eyes[0]);
  const double span = 2 * double{frame.camera.tan_half_fov} / size;
  const glm::dvec3 along =
      glm::normalize(glm::dvec3(frame.camera.forward) + (x + 0.5 - size / 2) * span * glm::dvec3(frame.camera.right) -
                     (y + 0.5 - size / 2) * span * glm::dvec3(frame.camera.up));
  const glm::dvec3 from = glm::dvec3(frame.camera.position) / 0.1 - glm::dvec3(0, 0, shape.cornea_centre);
  const double half = glm::dot(from, along),
               inner = half * half - glm::dot(from, from) + shape.cornea_radius * shape.cornea_radius;
  if (inner <= 0) return std::nullopt;
  const glm::dvec3 away = from - along * (half + std::sqrt(inner));
  const glm::dvec3 position = away + glm::dvec3(0, 0, shape.cornea_centre);
  if (position.z < shape.limbus || std::hypot(position.x, position.y) > 0.9 * shape.iris_radius) return std::nullopt;
  const glm::dvec3 inside = *refract_into(along, away / shape.cornea_radius, shape.refraction);
  const glm::dvec3 hit = position + inside * ((position.z - shape.iris_plane) / -inside.z);
  const double reach = std::hypot(hit.x, hit.y), edge = *frame.eyes[0].pupil.size * shape.iris_radius;
  if (std::abs(reach - edge) < 0.10 || reach > 0.85 * shape.iris_radius) return std::nullopt;  // near an edge
  return reach < edge;
}

TEST_F(Eyes, PupilLiesWhereRefractionPutsIt) {
  FurEye eye;
  eye.pupil.size = 0.4;
  eye.iris.depth = 0.3, eye.iris.limbal_ring = 0;
  for (const double refraction : {1.0, 1.376, 2.0}) {
    eye.refraction = refraction;
    FurFrame frame = frame_with(eye);
    frame.background_colour = glm::vec3(0), frame.lights.clear();
    frame.knobs.eye_steps = 1;
    for (const float degrees : {0.f, 30.f, 50.f}) {
      look_from(frame, degrees);
      const std::vector<glm::vec4> pixels = draw(frame);
      int inside = 0, wrong = 0;
      for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
          const std::optional<bool> pupil = sees_pupil(frame, x, y);
          if (!pupil) continue;
          inside += *pupil;
          wrong += *pupil != (pixels[static_cast<std::size_t>(y * size + x)].r < 1e-3f);
        }
      }
      EXPECT_GT(inside, 50);
      EXPECT_LE(wrong, 2) << refraction << " " << degrees;
    }
  }
}

/// Cosine to the normal where the ray of a pixel hits an eyeball without a bulge; none if it misses.
std::optional<double> cosine_on_ball(const FurFrame& frame, int x, int y) {
  const double span = 2 * double{frame.camera.tan_half_fov} / size;
  const glm::dvec3 along = glm::normalize(glm::dvec3((x + 0.5 - size / 2) * span, -(y + 0.5 - size / 2) * span, -1));
  const glm::dvec3 from = glm::dvec3(frame.camera.position) / 0.1;
  const double half = glm::dot(from, along), inner = half * half - glm::dot(from, from) + 1;
  if (inner <= 0) return std::nullopt;
  return std::sqrt(inner);
}

/// science.md 5: the cornea reflects the Fresnel share of the same surroundings, for any index.
TEST_F(Eyes, MirrorWhatFresnelSays) {
  FurEye eye;
  eye.bulge = 0, eye.wetness = 1;
  eye.sclera = eye.iris.colour = eye.iris.inner_colour = glm::vec3(0);
  const auto drawn = [&](double refraction) {
    eye.refraction = refraction;
    FurFrame frame = frame_with(eye);
    frame.lights.clear();
    return draw(frame);
  };
  const std::vector<glm::vec4> cornea = drawn(1.376), glass = drawn(3), nothing = drawn(1);
  int seen = 0;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const std::optional<double> cosine = cosine_on_ball(frame_with(eye), x, y);
      const std::size_t i = static_cast<std::size_t>(y * size + x);
      if (!cosine || *cosine < 0.05 || cornea[i].a < 1) continue;
      ++seen;
      ASSERT_LT(nothing[i].g, 1e-6f);
      ASSERT_NEAR(double(cornea[i].g) / double(glass[i].g) / (fresnel(*cosine, 1.376) / fresnel(*cosine, 3)), 1, 5e-3)
          << *cosine;
    }
  }
  EXPECT_GT(seen, 2000);
}

/// science.md 5: a grey picture of an iris can be tinted to any colour.
TEST_F(Eyes, TheIrisTakesItsTint) {
  FurEye eye;
  eye.wetness = 0, eye.refraction = 1;
  eye.iris.limbal_ring = 0, eye.iris.size = 0.8, eye.pupil.size = 0.2;
  const auto drawn = [&](glm::vec3 colour) {
    eye.iris.colour = eye.iris.inner_colour = colour;
    FurFrame frame = frame_with(eye);
    frame.knobs.eye_steps = 1;
    return draw(frame);
  };
  const glm::vec3 tint(0.2f, 0.5f, 0.9f);
  const std::vector<glm::vec4> grey = drawn(glm::vec3(1)), tinted = drawn(tint);
  int seen = 0;
  for (int y = size / 2 - 12; y < size / 2 + 12; ++y) {
    for (int x = size / 2 - 12; x < size / 2 + 12; ++x) {
      const std::size_t i = static_cast<std::size_t>(y * size + x);
      seen += grey[i].g > 0.05f;
      ASSERT_LT(glm::distance(glm::vec3(tinted[i]), tint * glm::vec3(grey[i])), 1e-4f) << x << " " << y;
    }
  }
  EXPECT_GT(seen, 300);
}

/// Mean light of the left and of the right half of the picture.
glm::dvec2 halves(const std::vector<glm::vec4>& pixels) {
  glm::dvec2 sum(0);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x)
      sum[x < size / 2 ? 0 : 1] += double{pixels[static_cast<std::size_t>(y * size + x)].r};
  }
  return sum / (0.5 * size * size);
}

TEST_F(Eyes, CausticIsBrighterOppositeTheLight) {
  FurEye eye;
  eye.iris.size = 0.95, eye.iris.depth = 0.3, eye.pupil.size = 0;
  eye.wetness = 0;
  FurFrame frame = frame_with(eye);
  frame.background_colour = glm::vec3(0), frame.look.ambient = 0;
  frame.lights[0].direction = glm::normalize(glm::vec3(-1, 0, -0.9f));  // from the right
  const glm::dvec2 light = halves(draw(frame));
  EXPECT_GT(light.x, 1.1 * light.y);
}

TEST_F(Eyes, TheMarchConverges) {
  FurFrame frame = frame_with({});
  look_from(frame, 40);
  const auto with = [&](int steps) {
    frame.knobs.eye_steps = steps;
    return draw(frame);
  };
  const auto apart = [](const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(double{a[i].r} - double{b[i].r});
    return sum;
  };
  const auto truth = with(64), fine = with(24), coarse = with(4), parallax = with(1), flat = with(0);
  EXPECT_LT(apart(fine, truth), 0.6 * apart(coarse, truth));
  EXPECT_LT(apart(coarse, truth), 0.8 * apart(parallax, truth));
  EXPECT_LT(apart(parallax, truth), apart(flat, truth));
}

TEST_F(Eyes, LidsCloseAndShade) {
  FurEye eye;
  eye.lids = FurLids{glm::mat3(1), {1.1f, -0.2f, -0.2f}, glm::vec3(0)};
  FurFrame frame = frame_with(eye);
  const auto redness = [&] {
    double sum = 0;
    for (const glm::vec4& pixel : draw(frame)) sum += double{pixel.r} - double{pixel.b};
    return sum;
  };
  frame.lights.clear(), frame.background_colour = glm::vec3(0);
  const double shut = redness();
  frame.eyes[0].lids->opening = {1.1f, 0.6f, 0.6f};
  const double open = redness();
  frame.eyes[0].lids.reset();
  const double bare = redness();
  EXPECT_NEAR(shut, 0, 0.05);
  EXPECT_GT(open, 10);
  EXPECT_GT(bare, 1.2 * open);
}

TEST_F(Eyes, ALightIsASharpDiscOnAWetEye) {
  FurEye eye;
  eye.wetness = 1, eye.sclera = eye.iris.colour = eye.iris.inner_colour = glm::vec3(0);
  const auto peak = [&] {
    float max = 0;
    const std::vector<glm::vec4> pixels = draw(frame_with(eye));
    for (int y = size / 4; y < size * 3 / 4; ++y) {
      for (int x = size / 4; x < size * 3 / 4; ++x)
        max = std::max(max, pixels[static_cast<std::size_t>(y * size + x)].b);
    }
    return max;
  };
  const float wet = peak();
  eye.wetness = 0;
  EXPECT_GT(wet, 4 * peak());
  EXPECT_GT(wet, 1);
}

}  // namespace
}  // namespace pelage::testing::eye_test
