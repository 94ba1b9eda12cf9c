#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/motion/meadow.h"

namespace pelage {
namespace {

Wind breeze() { return {.speed = 0.6, .direction = {2, 0, 1}}; }

TEST(Sway, WithoutWindNothingMoves) {
  const Meadow meadow = make_meadow();
  EXPECT_EQ(swayed(meadow.fur(), Wind{}, 5), meadow.direction);
  EXPECT_TRUE(make_wind(Wind{}).waves.empty());
  EXPECT_FALSE(has_wind(Wind{}));
}

TEST(Sway, FurWithoutLengthStays) {
  Meadow meadow = make_meadow();
  meadow.length[3] = 0;
  const BodyMotion pushed{[](std::uint32_t, double) { return glm::dvec3(1, 0, 0); }};
  const std::vector<glm::vec2> moved = swayed(meadow.fur(), breeze(), 1, &pushed);
  EXPECT_EQ(moved[3], meadow.direction[3]);
  EXPECT_NE(moved[4], meadow.direction[4]);
}

TEST(Sway, LeansWithTheWind) {
  const Meadow meadow = make_meadow();
  double along = 0, across = 0;
  for (const glm::vec2 lean : swayed(meadow.fur(), {.speed = 1, .direction = {1, 0, 0}, .turbulence = 0}, 1))
    along += lean.x, across += std::abs(lean.y + 0.3);
  const auto count = static_cast<double>(meadow.direction.size());
  EXPECT_GT(along / count, 0.25);
  EXPECT_LT(across / count, 0.15);
}

TEST(Sway, SameMomentSameBitsWhateverWasComputedBefore) {
  const Meadow meadow = make_meadow();
  const std::vector<glm::vec2> first = swayed(meadow.fur(), breeze(), 7.125);
  for (const double time : {0.0, 7.1, 900.0}) swayed(meadow.fur(), breeze(), time);
  EXPECT_EQ(swayed(meadow.fur(), breeze(), 7.125), first);
}

// Threads process runs of vertices, so the bits do not depend on the number of threads.
TEST(Sway, AVertexHasTheSameBitsAmongOthersAndAlone) {
  const Meadow meadow = make_meadow(40);
  const std::vector<glm::vec2> all = swayed(meadow.fur(), breeze(), 2);
  for (const std::size_t v : {std::size_t{0}, std::size_t{511}, std::size_t{512}, std::size_t{1599}}) {
    const RestFur fur = meadow.fur();
    const RestFur one{fur.positions.subspan(v, 1), fur.normals.subspan(v, 1), fur.tangents.subspan(v, 1),
                      fur.direction.subspan(v, 1), fur.length.subspan(v, 1),  {}};
    EXPECT_EQ(swayed(one, breeze(), 2)[0], all[v]);
  }
}

TEST(Sway, MotionHasNoJumps) {
  const Meadow meadow = make_meadow();
  const auto largest_step = [&](double step) {
    double largest = 0;
    for (int i = 0; i < 48; ++i)
      largest = std::max(largest, largest_change(swayed(meadow.fur(), breeze(), i / 8.0),
                                                 swayed(meadow.fur(), breeze(), i / 8.0 + step)));
    return largest;
  };
  const double whole = largest_step(1.0 / 24), half = largest_step(1.0 / 48), tiny = largest_step(1e-3);
  EXPECT_GT(whole, 0.02);
  EXPECT_LT(half, 0.6 * whole);
  EXPECT_LT(tiny, 0.05 * whole);
}

TEST(Sway, BodyThatComesIntoTheWarmUpDoesNotPop) {
  const Meadow meadow = make_meadow(2);
  const Wind calm{.frequency = 0.05, .damping = 0.05};  // swings for longer than the warm-up
  const BodyMotion knocked{[](std::uint32_t, double t) { return glm::dvec3(t > 0 && t < 0.1 ? 0.01 : 0, 0, 0); }};
  double largest = 0;
  for (double t = 0.2; t < warm_up_seconds + 0.4; t += 1.0 / 60)
    largest = std::max(largest, largest_change(swayed(meadow.fur(), calm, t, &knocked),
                                               swayed(meadow.fur(), calm, t + 1.0 / 60, &knocked)));
  EXPECT_LT(largest, 0.004);
  EXPECT_LT(largest_change(swayed(meadow.fur(), calm, warm_up_seconds + 0.2, &knocked), meadow.direction), 1e-6);
  EXPECT_GT(largest_change(swayed(meadow.fur(), calm, 1, &knocked), meadow.direction), 0.02);
}

TEST(Sway, OffsetDirectionKeepsTheUnmovedAndTheDiscAndIsSmooth) {
  for (const glm::dvec2 still : {glm::dvec2(0), glm::dvec2(0.5, 0.2), glm::dvec2(0.6, 0.8)}) {
    EXPECT_EQ(offset_direction(still, {0, 0}), still);
    for (double angle = 0; angle < 6.28; angle += 0.37) {
      const glm::dvec2 direction(std::cos(angle), std::sin(angle));
      for (double far = 0; far < 4; far += 0.01) {
        EXPECT_LE(glm::length(offset_direction(still, far * direction)), 1 + 1e-12);
        EXPECT_LT(
            glm::length(offset_direction(still, (far + 0.01) * direction) - offset_direction(still, far * direction)),
            0.0101);
      }
    }
  }
  EXPECT_NEAR(glm::length(offset_direction({0.1, 0}, {1e9, 1e9})), 1, 1e-9);
  for (double far = 0; far < 2; far += 0.01) {  // the speed is continuous at the border
    const auto length = [&](double at) { return glm::length(offset_direction({0.3, 0}, {at, 0})); };
    EXPECT_LT(std::abs(length(far + 0.02) - 2 * length(far + 0.01) + length(far)), 3e-4);
  }
}

TEST(Wind, GustsTravelWithTheWind) {
  const WindField field = make_wind({.speed = 2, .direction = {1, 0, 0}, .gusts = 1, .turbulence = 0});
  double with = 0, still = 0;
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 position(0.01 * i, 0, 0.003 * i);
    const double time = 0.1 * i, speed = field.velocity(position, time).x;
    with += std::abs(field.velocity(position + glm::dvec3(0.6, 0, 0), time + 0.3).x - speed);
    still += std::abs(field.velocity(position, time + 0.3).x - speed);
  }
  EXPECT_LT(with, 0.5 * still);
}

TEST(Wind, VariesAsMuchAsAskedAndBySeed) {
  for (const std::uint32_t seed : {1u, 2u, 77u}) {
    const Wind wind{.speed = 3, .gusts = 0.5, .turbulence = 0.25, .seed = seed};
    const WindField field = make_wind(wind);
    double square = 0;
    for (int i = 0; i < 4000; ++i) {
      const glm::dvec3 change = field.velocity({0.37 * i, 0.11 * i, 0}, 1.7 * i) - field.mean;
      square += glm::dot(change, change) / 4000;
    }
    EXPECT_NEAR(std::sqrt(square), 3 * std::hypot(0.5, 0.25), 0.1);
  }
  EXPECT_NE(make_wind({.speed = 1, .seed = 1}).velocity({}, 0), make_wind({.speed = 1, .seed = 2}).velocity({}, 0));
}

}  // namespace
}  // namespace pelage
