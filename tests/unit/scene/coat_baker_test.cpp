#include "server/frames/coat_baker.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <limits>
#include <thread>

namespace pelage::coat_baker_test {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t no_bound = std::numeric_limits<std::size_t>::max();
constexpr int coarsest = slice_levels - 1;

CoatNeed need_of(double tile, int finest = coarsest) {
  CoatNeed need{.coat = {}, .finest = finest};
  need.coat.tile = tile;
  return need;
}

bool soon(const std::function<bool()>& holds) {
  for (int i = 0; i < 12000 && !holds(); ++i) std::this_thread::sleep_for(5ms);
  return holds();
}

TEST(CoatBaker, BakesOnceForAllWhoAsk) {
  CoatBaker baker(2, no_bound, [] {});
  std::vector<std::future<std::shared_ptr<const Slices>>> answers;
  for (int i = 0; i < 16; ++i)
    answers.push_back(std::async(std::launch::async, [&] { return baker.wait(need_of(0.05), {}); }));
  std::vector<std::shared_ptr<const Slices>> slices;
  for (auto& answer : answers) slices.push_back(answer.get());
  for (const auto& one : slices) EXPECT_EQ(one, slices.front()) << "held by all, so it is the same";
  EXPECT_EQ(slices.front()->levels.size(), std::size_t{slice_levels});
  EXPECT_EQ(baker.baked(), 1u);
}

TEST(CoatBaker, WhoNeedsLessTakesWhatIsThereAndWhoNeedsMoreDoesNot) {
  CoatBaker baker(1, no_bound, [] {});
  const CoatBaker::Handle coarse = baker.ask(need_of(0.05, 6));
  EXPECT_EQ(baker.ask(need_of(0.05, 7)), coarse);
  EXPECT_NE(baker.ask(need_of(0.05, 5)), coarse);
  EXPECT_NE(baker.ask(need_of(0.06, 6)), coarse);
}

TEST(CoatBaker, TheLastWhoLetsGoEndsIt) {
  CoatBaker baker(1, no_bound, [] {});
  CoatBaker::Handle first = baker.ask(need_of(0.05, 0)), second = first;
  const CoatBaker::Handle other = baker.ask(need_of(0.06));  // waits for the first
  first.reset();
  std::this_thread::sleep_for(50ms);
  EXPECT_FALSE(second->settled() && !second->slices()) << "somebody still waits for it";
  if (second->settled()) GTEST_SKIP() << "the machine bakes too fast to let go in time";
  second.reset();
  EXPECT_TRUE(soon([&] { return other->settled(); }));
  EXPECT_EQ(baker.baked(), 1u) << "the other alone";
}

TEST(CoatBaker, NobodyWaitsThatWasGivenUp) {
  CoatBaker baker(1, no_bound, [] {});
  int pauses = 0;
  EXPECT_EQ(baker.wait(need_of(0.05, 0), [&] { return ++pauses < 3; }), nullptr);
  EXPECT_EQ(pauses, 3);
  EXPECT_NE(baker.wait(need_of(0.05), [] { return true; }), nullptr);
}

TEST(CoatBaker, WhatDoesNotFitWaitsAndOneAloneNever) {
  CoatBaker baker(2, 1, [] {});
  CoatBaker::Handle first = baker.ask(need_of(0.05));
  const CoatBaker::Handle second = baker.ask(need_of(0.06));
  ASSERT_TRUE(soon([&] { return first->settled(); }));
  EXPECT_NE(first->slices(), nullptr);
  EXPECT_EQ(baker.bytes(), slices_bytes(coarsest));
  std::this_thread::sleep_for(100ms);
  EXPECT_FALSE(second->settled()) << "the first takes the room as long as somebody holds it";
  first.reset();
  EXPECT_TRUE(soon([&] { return second->settled(); }));
}

TEST(CoatBaker, SaysWhatItTakes) {
  const Slices slices = bake_slices({}, 2);
  std::size_t bytes = 0;
  for (const SliceLevel& level : slices.levels) bytes += level.shape.size() + level.colour.size();
  EXPECT_EQ(slices_bytes(2), bytes);
  EXPECT_GT(baking_bytes(0), 4 * slices_bytes(0)) << "texels are larger while they are baked";
  EXPECT_GT(baking_bytes(2), slices_bytes(2));
  EXPECT_LT(baking_bytes(2), baking_bytes(0) / 4);
}

TEST(CoatBaker, EndsWhileItBakes) {
  CoatBaker::Handle held;
  {
    CoatBaker baker(1, no_bound, [] {});
    held = baker.ask(need_of(0.05, 0));
    std::this_thread::sleep_for(20ms);
  }
  EXPECT_TRUE(held->settled() || !held->slices());
}

}  // namespace
}  // namespace pelage::coat_baker_test
