#include "base/parallel.h"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/resource.h>

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>
#include <vector>

namespace pelage {
namespace {

TEST(Parallel, EachNumberIsWorkedOnOnce) {
  for (const int threads : {1, 2, 5, 64}) {
    std::vector<int> visits(1000, 0);
    for_each_in_parallel(
        1000, [&](std::uint32_t i) { ++visits[i]; }, threads);
    EXPECT_EQ(visits, std::vector<int>(1000, 1)) << threads << " threads";
  }
  for_each_in_parallel(0, [](std::uint32_t) { FAIL() << "there is nothing to do"; });
}

/// Farms and containers pin processes like this. Runs in a child, because the pinning would affect the other tests.
TEST(ParallelDeathTest, SingleCoreRunsInline) {
  const auto pinned = [] {
    cpu_set_t cores, one;
    sched_getaffinity(0, sizeof cores, &cores);
    CPU_ZERO(&one);
    for (std::size_t core = 0; CPU_COUNT(&one) == 0; ++core)
      if (CPU_ISSET(core, &cores)) CPU_SET(core, &one);
    sched_setaffinity(0, sizeof one, &one);
    const auto caller = std::this_thread::get_id();
    bool others = false;
    for_each_in_parallel(
        1000, [&](std::uint32_t) { others |= std::this_thread::get_id() != caller; }, 4);
    std::exit(core_count() == 1 && default_threads() == 1 && !others ? 0 : 1);
  };
  testing::GTEST_FLAG(death_test_style) = "threadsafe";  // oneTBB counts cores only once
  EXPECT_EXIT(pinned(), testing::ExitedWithCode(0), "^$");
}

TEST(Parallel, RunsCoverTheRangeWithoutOverlap) {
  constexpr std::uint32_t count = 100'001;
  std::vector<int> visits(count, 0);
  for_each_range_in_parallel(count, [&](std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i) ++visits[i];
  });
  EXPECT_EQ(visits, std::vector<int>(count, 1));
}

TEST(Parallel, AnExceptionReachesTheCallerAndStopsTheRest) {
  std::atomic<int> calls = 0;
  const auto work = [&](std::uint32_t i) {
    ++calls;
    if (i == 0) throw std::runtime_error("no more");
  };
  EXPECT_THROW(for_each_in_parallel(1'000'000, work, 2), std::runtime_error);
  EXPECT_LT(calls, 1'000'000);
}

TEST(Parallel, BothAreCalled) {
  int first = 0, second = 0;
  run_both([&] { first = 1; }, [&] { second = 2; });
  EXPECT_EQ(first, 1);
  EXPECT_EQ(second, 2);
}

/// Leaves no address space for the stack of another thread.
void allow_no_more_threads() {
  std::ifstream status("/proc/self/statm");
  rlim_t pages = 0;
  status >> pages;
  const rlim_t bytes = pages * 4096 + (rlim_t{6} << 20);  // less than a stack more than now
  const rlimit limit{bytes, bytes};
  if (setrlimit(RLIMIT_AS, &limit) != 0) std::abort();
}

TEST(ParallelDeathTest, WorkIsDoneWhereNoThreadCanStart) {
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  EXPECT_EXIT(
      {
        std::atomic<int> calls = 0;
        allow_no_more_threads();
        for (int loop = 0; loop < 3; ++loop)
          for_each_in_parallel(
              100, [&](std::uint32_t) { ++calls; }, 4);
        std::exit(calls == 300 ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace pelage
