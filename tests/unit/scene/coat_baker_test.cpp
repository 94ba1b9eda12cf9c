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

Coat coat_of(double tile) {
  Coat coat;
  coat.tile = tile;
  return coat;
}

bool soon(const std::function<bool()>& holds) {
  for (int i = 0; i < 12000 && !holds(); ++i) std::this_thread::sleep_for(5ms);
  return holds();
}

TEST(CoatBaker, BakesOnceForAllWhoAsk) {
  CoatBaker baker(2, no_bound, [] {});
  std::vector<std::future<std::shared_ptr<const Slices>>> answers;
  for (int i = 0; i < 16; ++i)
    answers.push_back(std::async(std::launch::async, [&] { return baker.wait(coat_of(0.05)); }));
  std::vector<std::shared_ptr<const Slices>> slices;
  for (auto& answer : answers) slices.push_back(answer.get());
  for (const auto& one : slices) EXPECT_EQ(one, slices.front()) << "held by all, so it is the same";
  EXPECT_EQ(slices.front()->levels.size(), std::size_t{slice_levels});
  EXPECT_EQ(baker.baked(), 1u);
}

TEST(CoatBaker, EndsWhenItsLastHandleGoes) {
  CoatBaker baker(1, no_bound, [] {});
  CoatBaker::Handle first = baker.submit(coat_of(0.05)), second = first;
  const CoatBaker::Handle other = baker.submit(coat_of(0.06));  // waits for the first one to end
  first.reset();
  std::this_thread::sleep_for(50ms);
  EXPECT_FALSE(second->settled() && !second->slices()) << "somebody still waits for it";
  if (second->settled()) GTEST_SKIP() << "the machine bakes too fast to let go in time";
  second.reset();
  EXPECT_TRUE(soon([&] { return other->settled(); }));
  EXPECT_EQ(baker.baked(), 1u) << "the other alone";
}

TEST(CoatBaker, WaitsForRoomUnlessItIsAlone) {
  CoatBaker baker(2, 1, [] {});
  CoatBaker::Handle first = baker.submit(coat_of(0.05));
  const CoatBaker::Handle second = baker.submit(coat_of(0.06));
  ASSERT_TRUE(soon([&] { return first->settled(); }));
  EXPECT_NE(first->slices(), nullptr);
  EXPECT_EQ(baker.bytes(), slices_bytes());
  std::this_thread::sleep_for(100ms);
  EXPECT_FALSE(second->settled()) << "the first takes the room as long as somebody holds it";
  first.reset();
  EXPECT_TRUE(soon([&] { return second->settled(); }));
}

TEST(CoatBaker, ReportsTheBytesOfSlicesAndOfBaking) {
  const Slices slices = bake_slices({});
  std::size_t bytes = 0;
  for (const SliceLevel& level : slices.levels) bytes += level.shape.size() + level.colour.size();
  EXPECT_EQ(slices_bytes(), bytes);
  EXPECT_GT(baking_bytes(), 4 * slices_bytes()) << "texels are larger while they are baked";
}

TEST(CoatBaker, EndsWhileItBakes) {
  CoatBaker::Handle held;
  {
    CoatBaker baker(1, no_bound, [] {});
    held = baker.submit(coat_of(0.05));
    std::this_thread::sleep_for(20ms);
  }
  EXPECT_TRUE(held->settled() || !held->slices());
}

}  // namespace
}  // namespace pelage::coat_baker_test
