// Threads that answer requests: every task is done, on as few threads as possible.
#include "server/http/transport/workers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <set>
#include <thread>

namespace pelage {
namespace {

TEST(Workers, UsesAsFewThreadsAsPossible) {
  Workers workers(32, 8);
  std::set<std::thread::id> seen;
  for (int i = 0; i < 400; ++i) {
    std::promise<std::thread::id> done;
    ASSERT_TRUE(workers.enqueue([&] { done.set_value(std::this_thread::get_id()); }, i % 2 == 0));
    seen.insert(done.get_future().get());
    std::this_thread::sleep_for(std::chrono::milliseconds(2));  // lets the worker wait again
  }
  EXPECT_LE(seen.size(), 8u);
}

TEST(Workers, ManyAtOnceAreAllDone) {
  std::atomic<int> done = 0;
  {
    Workers workers(8, 100000);
    std::vector<std::thread> givers;
    for (int k = 0; k < 4; ++k) {
      givers.emplace_back([&] {
        for (int i = 0; i < 5000; ++i) ASSERT_TRUE(workers.enqueue([&] { ++done; }, i % 7 == 0));
      });
    }
    for (std::thread& giver : givers) giver.join();
  }
  EXPECT_EQ(done, 20000);
}

TEST(Workers, UrgentTasksRunWhileAllOthersAreBusy) {
  Workers workers(2, 100);
  std::promise<void> end;
  const std::shared_future<void> ended = end.get_future().share();
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(workers.enqueue([ended] { ended.wait(); }, false));
  std::promise<void> urgent;
  ASSERT_TRUE(workers.enqueue([&] { urgent.set_value(); }, true));
  EXPECT_EQ(urgent.get_future().wait_for(std::chrono::seconds(20)), std::future_status::ready);
  end.set_value();
}

TEST(Workers, RefuseWhatIsMoreThanMayWait) {
  Workers workers(1, 2);
  std::promise<void> end;
  const std::shared_future<void> ended = end.get_future().share();
  int taken = 0;
  for (int i = 0; i < 10; ++i) taken += workers.enqueue([ended] { ended.wait(); }, false) ? 1 : 0;
  EXPECT_GE(taken, 2);
  EXPECT_LE(taken, 3);
  end.set_value();
}

}  // namespace
}  // namespace pelage
