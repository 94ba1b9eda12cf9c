// Long work beside the thread that draws.
#include "renderer/frame/run_beside.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>

namespace pelage::run_beside_test {
namespace {

TEST(RunBeside, AsksUntilTheWorkIsDone) {
  int pauses = 0;
  std::atomic<bool> enough = false;
  const auto done = run_beside([&] { return enough = ++pauses >= 3, true; },
                               [&](const auto& go_on) {
                                 while (!enough && go_on()) std::this_thread::yield();
                                 return 7;
                               });
  EXPECT_EQ(done, 7);
  EXPECT_GE(pauses, 3);
}

TEST(RunBeside, EndsTheWorkOnceThePauseGivesUp) {
  const auto done = run_beside([] { return false; },
                               [](const auto& go_on) {
                                 while (go_on()) std::this_thread::yield();
                                 return 7;
                               });
  EXPECT_FALSE(done);
}

TEST(RunBeside, EndsTheWorkOnceThePauseThrows) {
  const auto pause = []() -> bool { throw std::runtime_error("no memory for who was let in"); };
  std::atomic<bool> ended = false;
  const auto work = [&](const auto& go_on) {
    while (go_on()) std::this_thread::yield();
    ended = true;
    return 7;
  };
  EXPECT_THROW(run_beside(pause, work), std::runtime_error);
  EXPECT_TRUE(ended);
}

}  // namespace
}  // namespace pelage::run_beside_test
