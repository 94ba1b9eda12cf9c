// A parallel loop that ends at the first call that returns false.
#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

#include "base/parallel.h"

namespace pelage::threads_until_false_test {
namespace {

TEST(ForEachUntilFalse, RethrowsWhatACallThrows) {
  const auto work = [](std::size_t number) -> bool {
    if (number == 3) throw std::runtime_error("no more");
    return true;
  };
  for (const bool yielding : {false, true})
    EXPECT_THROW(for_each_until_false({.threads = 2, .yielding = yielding}, 100, work), std::runtime_error) << yielding;
}

TEST(ForEachUntilFalse, ReturnsWhetherAllReturnedTrue) {
  for (const bool yielding : {false, true}) {
    for (const int threads : {1, 3}) {
      std::atomic<int> calls{0};
      const WorkThreads workers{.threads = threads, .yielding = yielding};
      EXPECT_TRUE(for_each_until_false(workers, 50, [&](std::size_t) { return ++calls > 0; }));
      EXPECT_EQ(calls, 50);
      EXPECT_FALSE(for_each_until_false(workers, 1000, [&](std::size_t) { return ++calls < 60; }));
      EXPECT_LT(calls, 1000);
    }
  }
}

}  // namespace
}  // namespace pelage::threads_until_false_test
