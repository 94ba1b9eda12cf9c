#include "server/frames/yield_gate.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <optional>
#include <thread>

namespace pelage::yield_gate_test {
namespace {

using namespace std::chrono_literals;

TEST(YieldGate, IsOpenWhileNobodyGoesFirst) {
  YieldGate gate;
  EXPECT_TRUE(gate.pass([] { return true; }));
  EXPECT_FALSE(gate.pass([] { return false; }));
}

TEST(YieldGate, HoldsUntilTheLastTurnEnds) {
  YieldGate gate;
  auto first = std::make_optional<YieldGate::Priority>(gate);
  auto second = std::make_optional<YieldGate::Priority>(gate);
  std::future<bool> passed = std::async(std::launch::async, [&] { return gate.pass([] { return true; }); });
  EXPECT_EQ(passed.wait_for(50ms), std::future_status::timeout);
  first.reset();
  EXPECT_EQ(passed.wait_for(50ms), std::future_status::timeout);
  second.reset();
  EXPECT_TRUE(passed.get());
}

TEST(YieldGate, LetsGoOfWhatIsNoLongerWanted) {
  YieldGate gate;
  const YieldGate::Priority turn = gate.take_priority();
  std::atomic<bool> wanted{true};
  std::future<bool> passed = std::async(std::launch::async, [&] { return gate.pass([&] { return wanted.load(); }); });
  EXPECT_EQ(passed.wait_for(50ms), std::future_status::timeout);
  wanted = false;
  gate.wake();
  EXPECT_FALSE(passed.get());
}

TEST(YieldGate, HoldsBackAllThatYield) {
  YieldGate gate;
  auto turn = std::make_optional<YieldGate::Priority>(gate);
  std::atomic<int> through{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) threads.emplace_back([&] { through += gate.pass([] { return true; }) ? 1 : 0; });
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(through, 0);
  turn.reset();
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(through, 8);
}

}  // namespace
}  // namespace pelage::yield_gate_test
