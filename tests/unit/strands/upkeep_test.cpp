// Strands over many changes and with any amount of memory; how thinning changes the picture.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "renderer/strands/world.h"
#include "tests/unit/strands/traced_ball.h"

namespace pelage {
namespace {

Status traced_in(Tracer& tracer, const FurPatch& fur, const FurFrame& frame) {
  Status status = tracer.begin(fur.model(), fur.fields(), frame, nothing(), std::array{Aov::beauty}, always);
  while (status.ok() && tracer.report().end == TraceEnd::none) status = tracer.add_pass(always);
  return status;
}

TEST(Upkeep, AnyMemorySufficesOrIsRefused) {
  const FurPatch ball = fur_ball(0.04f), bald = fur_ball(0);
  FurPatch small(0.02);
  small.id = 2;
  FurFrame frame = frame_at(16, coat_of(glm::vec3(0.5f), 1000), Transport::transmittance, 1);
  FurFrame less = frame;
  less.coat().count = 30;
  const std::vector<float> whole = traced(ball, frame).beauty.rgba;
  int refused = 0, done = 0;
  for (std::size_t memory = std::size_t{256} << 10; memory <= std::size_t{128} << 20; memory *= 2) {
    Tracer tracer(2, memory, false);
    const Status status = traced_in(tracer, ball, frame);
    if (status.ok()) {
      EXPECT_EQ(tracer.aov(Aov::beauty).rgba, whole) << memory;
      ++done;
    } else {
      EXPECT_EQ(status.code, Code::too_large) << status.message;
      EXPECT_FALSE(status.pointer.empty());
      ++refused;
    }
    const Status again = traced_in(tracer, ball, frame);
    EXPECT_EQ(again.code, status.code) << memory;
    if (traced_in(tracer, bald, frame).ok()) {  // the skin may have been what did not fit
      EXPECT_GT(mean_of(tracer.aov(Aov::beauty)).alpha, 10) << memory;
    }
    const Status fits = tracer.begin(small.model(), small.fields(), less, nothing(), std::array{Aov::beauty}, always);
    EXPECT_TRUE(fits.ok()) << memory << " " << fits.message;
    EXPECT_TRUE(tracer.add_pass(always).ok());
    EXPECT_EQ(traced_in(tracer, ball, frame).code, status.code) << memory;
  }
  EXPECT_GT(refused, 2);
  EXPECT_GT(done, 1);
}

TEST(Upkeep, FewerStrandsOfTheSameModelFitAfterTooMany) {
  const FurPatch ball = fur_ball(0.04f);
  FurFrame frame = frame_at(16, coat_of(glm::vec3(0.5f), 1000), Transport::transmittance, 1);
  std::size_t max = 0;
  {
    World world(plenty);
    ASSERT_TRUE(world.update(ball.model(), ball.fields(), frame, GrowRecipe{frame.coat()}, {1, false}, always));
    max = world.bytes();
  }
  World world(max + max / 8);
  for (const int count : {1000, 3000, 1000, 500, 1000}) {  // earlier strands are dropped for later ones
    frame.coat().count = count;
    const auto change = world.update(ball.model(), ball.fields(), frame, GrowRecipe{frame.coat()}, {2, false}, always);
    EXPECT_EQ(bool(change), count <= 1000) << count;
    frame.coat().bend += 0.1;
  }
}

TEST(Upkeep, WhiskersThatDidNotFitAreGrownWhenTheyDo) {
  FurPatch bald(0.02, 1, 0);
  FurFrame frame;
  const FurGuide guide{.points = {{0, 0, 0}, {0, 0, 0.2}}};
  frame.curves = {{.guides = std::vector<FurGuide>(400, guide), .width_root = 0.001, .fill = 0}};
  World world(12'000);
  for (int i = 0; i < 2; ++i)
    EXPECT_FALSE(
        world.update(bald.model(), bald.fields(), frame, GrowRecipe{coat_of(glm::vec3(1), 10)}, {1, false}, always));
  frame.curves[0].guides.resize(2);
  const auto few =
      world.update(bald.model(), bald.fields(), frame, GrowRecipe{coat_of(glm::vec3(1), 10)}, {1, false}, always);
  ASSERT_TRUE(few);
  EXPECT_EQ(few->strands, 2u);
}

void stroke(FurPatch& fur, std::mt19937& random) {
  const std::size_t first = random() % fur.length.size(), count = 1 + random() % 60;
  for (std::size_t i = first; i < std::min(first + count, fur.length.size()); ++i) {
    const auto any = [&] { return static_cast<float>(random() % 2001) / 1000 - 1; };
    fur.direction[i] = 0.7f * glm::vec2(any(), any());
    fur.length[i] = 0.04f * (1 + any());
  }
}

std::vector<float> hits_of_grid(const World& world) {
  std::vector<float> numbers;
  for (int y = -40; y <= 40; ++y) {
    for (int x = -40; x <= 40; ++x) {
      const Ray ray{.origin = {0.0085f * float(x), 0.0085f * float(y), 2}, .direction = {0, 0, -1}};
      const Hit hit = world.intersect(ray);
      const glm::vec3 transmittance = world.transmittance(ray, 0.3f);
      for (const float value : {float(int(hit.kind)), hit.distance, hit.offset, hit.height, hit.colour.r, hit.tangent.x,
                                hit.normal.y, hit.number, transmittance.r, transmittance.g, float(world.occluded(ray))})
        numbers.push_back(value);
    }
  }
  return numbers;
}

TEST(Upkeep, AfterManyStrokesTheWorldIsAsNewAndTakesAsMuch) {
  FurPatch ball = fur_ball(0.04f);
  std::mt19937 random(7);
  World world(plenty);
  const GrowRecipe recipe{.coat = coat_of(glm::vec3(0.5f), 300)};
  std::size_t partly = 0;
  for (int i = 0; i < 120; ++i) {
    stroke(ball, random);
    const auto change = world.update(ball.model(), ball.fields(), {}, recipe, {2, false}, always);
    ASSERT_TRUE(change);
    partly += change->grown < change->strands;
  }
  EXPECT_GT(partly, 80u);
  World fresh(plenty);
  ASSERT_TRUE(fresh.update(ball.model(), ball.fields(), {}, recipe, {1, false}, always));
  EXPECT_EQ(hits_of_grid(world), hits_of_grid(fresh));
  const auto taken = static_cast<double>(world.bytes()), needed = static_cast<double>(fresh.bytes());
  EXPECT_NEAR(taken / needed, 1, 0.02);
}

TEST(Upkeep, ChangesOfAllStrandsTakeNoMoreMemory) {
  FurPatch ball = fur_ball(0.04f);
  World world(plenty);
  Coat coat = coat_of(glm::vec3(0.5f), 200);
  std::size_t first = 0;
  for (int i = 0; i < 40; ++i) {
    coat.bend = 0.01 * (i % 10);
    for (float& length : ball.length) length = 0.04f + 1e-4f * static_cast<float>(i % 10);
    ASSERT_TRUE(world.update(ball.model(), ball.fields(), {}, GrowRecipe{coat}, {2, false}, always));
    if (i == 10) first = world.bytes();
  }
  ASSERT_TRUE(world.update(ball.model(), ball.fields(), {}, GrowRecipe{coat}, {2, false}, always));
  EXPECT_NEAR(static_cast<double>(world.bytes()) / static_cast<double>(first), 1, 0.02);
  FurPatch bald = ball;
  bald.length.assign(bald.length.size(), 0);
  ASSERT_TRUE(world.update(bald.model(), bald.fields(), {}, GrowRecipe{coat}, {2, false}, always));
  EXPECT_LT(world.bytes(), first / 10);  // only the skin is left
}

/// A camera whose picture shows the ball with pixels as large as in a 64-pixel picture with a field of view of 23
/// degrees.
FurFrame view_from(double distance) {
  const double pixel = 0.4 / 64 * distance;
  const int size = static_cast<int>(std::ceil(0.7 / pixel));
  FurFrame frame =
      frame_at(size, coat_of(glm::vec3(0.5f), 4000), Transport::transmittance, std::max(1, 20'000 / (size * size)));
  frame.coat().width_root = 0.0004, frame.coat().width_tip = 0.00015;
  frame.camera.position = {0, 0, distance};
  frame.camera.tan_half_fov = static_cast<float>(size * pixel / 2 / distance);
  return frame;
}

/// Share of that picture that the world covers, with all strands.
double covered(const World& world, const FurFrame& frame) {
  constexpr int side = 160;
  int hits = 0;
  for (int i = 0; i < side * side; ++i) {
    const glm::vec2 off = (glm::vec2(i % side, i / side) + 0.5f) * (2.0f / side) - 1.0f;
    const glm::vec3 towards(off * frame.camera.tan_half_fov, -1);
    hits +=
        world.intersect({.origin = frame.camera.position, .direction = glm::normalize(towards)}).kind != HitKind::none;
  }
  return double(hits) / (side * side);
}

// Strands thinner than a pixel are thinned out and widened, so that their coverage stays the same from any distance.
TEST(Upkeep, CoverageStaysFromAnyDistance) {
  for (const bool more_fur_than_body : {false, true}) {
    FurPatch ball = fur_ball(0.04f);
    World world(plenty);
    if (more_fur_than_body) {
      for (glm::vec3& position : ball.positions) position *= 0.3f;
    }
    ASSERT_TRUE(world.update(ball.model(), ball.fields(), {}, GrowRecipe{view_from(2).coat()}, {2, false}, always));
    std::size_t max = 0, min = 1u << 30;
    for (const double distance : {0.8, 8.0, 128.0}) {
      const FurFrame frame = view_from(distance);
      const Traced picture = traced(ball, frame);
      const double pixels = double(frame.width) * frame.height;
      const double seen = mean_of(picture.beauty).alpha / pixels, whole = covered(world, frame);
      EXPECT_NEAR(seen, whole, 0.03 * whole) << distance;
      max = std::max(max, picture.report.strands), min = std::min(min, picture.report.strands);
    }
    EXPECT_LT(min, max * 3 / 4);
  }
}

}  // namespace
}  // namespace pelage
