#include <gtest/gtest.h>

#include <string>

#include "server/frames/frame_queue.h"

namespace pelage::shortest_first_test {
namespace {

using Queue = ShortestFirst<std::string>;

std::string order_of(Queue& queue, int count = 1000) {
  std::string order;
  for (; count > 0; --count) {
    const auto taken = queue.take();
    if (!taken) break;
    order += taken->job;
  }
  return order;
}

TEST(ShortestFirst, ServesTheShortBeforeTheLong) {
  Queue queue;
  queue.add("c", 300, 0);
  queue.add("a", 1, 2);
  queue.add("b", 20, 1);
  EXPECT_EQ(order_of(queue), "abc");
  EXPECT_TRUE(queue.empty());
}

TEST(ShortestFirst, ServesEqualOnesInTheirOrder) {
  Queue queue;
  for (const char* name : {"a", "b", "c"}) queue.add(name, 5, 0);
  EXPECT_EQ(order_of(queue), "abc");
}

TEST(ShortestFirst, ALongOneDoesNotStarve) {
  Queue queue;
  queue.add("long", 1000, 0);
  int served = 0;
  for (double now = 0; now < 1e5; now += 10) {
    queue.add("short", 10, now);
    if (queue.take()->job == "long") break;
    ++served;
  }
  EXPECT_EQ(served, 792);  // then the long one has waited long enough
}

TEST(ShortestFirst, LetsInWhatIsShortBesideARunningOne) {
  Queue queue;
  queue.add("as long", 90, 0);
  queue.add("short", 40, 1);
  queue.add("barred", 1, 2);
  const std::uint64_t pause = queue.moment();
  queue.add("late", 1, 3);
  const auto may = [](const std::string& job) { return job != "barred"; };
  EXPECT_EQ(queue.take_interleaved(100, pause, may)->job, "short");
  EXPECT_FALSE(queue.take_interleaved(100, pause, may));  // so the running job goes on
  EXPECT_EQ(queue.take_interleaved(100, queue.moment(), may)->job, "late");
  EXPECT_EQ(queue.size(), 2u);
}

TEST(ShortestFirst, FindsOneToReplace) {
  Queue queue;
  queue.add("a", 1, 0);
  *queue.find([](const std::string& job) { return job == "a"; }) = "b";
  EXPECT_EQ(queue.find([](const std::string& job) { return job == "a"; }), nullptr);
  EXPECT_EQ(order_of(queue), "b");
}

TEST(ShortestFirst, AScenesManyFramesHoldUpNoOtherScene) {
  Queue queue;
  for (int i = 0; i < 64; ++i) queue.add("h", 20, i, {1, 0});
  for (int i = 0; i < 8; ++i) queue.take();
  queue.add("p", 20, 1e6, {2, 0});
  EXPECT_EQ(order_of(queue, 2), "hp") << "each has its turn, however late it comes";
  queue.add("p", 20, 1e6, {2, 0});
  EXPECT_EQ(order_of(queue, 2), "hp");
  queue.add("s", 20, 1e6, {1, 5});
  EXPECT_EQ(order_of(queue, 2), "hs") << "so have the views of one scene";
}

TEST(ShortestFirst, WhatIsPutBackKeepsItsPlaceInTheLine) {
  Queue queue;
  for (const char* name : {"a", "b", "c"}) queue.add(name, 5, 0);
  auto taken = queue.take();
  ASSERT_EQ(taken->job, "a");
  queue.put_back(std::move(*taken));
  EXPECT_FALSE(queue.take([](const std::string& job) { return job == "d"; }));
  EXPECT_EQ(queue.take([](const std::string& job) { return job != "a"; })->job, "b") << "a is not ready";
  EXPECT_EQ(order_of(queue), "ac");
}

}  // namespace
}  // namespace pelage::shortest_first_test
