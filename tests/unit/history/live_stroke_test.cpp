#include "server/history/live_stroke.h"

#include <gtest/gtest.h>

#include "tests/unit/history/comb_strokes.h"

namespace pelage {
namespace {

class LiveStrokeTest : public ::testing::Test {
 protected:
  LiveStroke::Plan send(const Command& command, bool changed = true) {
    const Result<LiveStroke::Plan> plan = live_.plan(command);
    EXPECT_TRUE(plan.ok());
    if (!plan.ok()) return {};
    live_.accept(*plan, command, changed);
    return *plan;
  }
  Status refusal(const Command& command) const {
    const auto plan = live_.plan(command);
    return plan.ok() ? Status{} : plan.status();
  }
  LiveStroke live_;
};

TEST_F(LiveStrokeTest, PartsJoin) {
  EXPECT_FALSE(send(comb_at(1, "k", 0, false)).joins);
  const LiveStroke::Plan second = send(comb_at(2, "k", 1, false));
  EXPECT_TRUE(second.joins);
  EXPECT_EQ(stroke_of(second.merged)->samples.size(), 4u);
  EXPECT_EQ(stroke_of(second.to_log)->samples.size(), 2u);
  EXPECT_EQ(stroke_of(send(comb_at(3, "k", 2, true)).merged)->samples.size(), 6u);
}

TEST_F(LiveStrokeTest, PartsThatMissAreLoggedWithTheNextOne) {
  EXPECT_FALSE(send(comb_at(1, "k", 0, false), false).joins);
  const LiveStroke::Plan second = send(comb_at(2, "k", 1, false));
  EXPECT_FALSE(second.joins);
  EXPECT_EQ(stroke_of(second.to_log)->samples.size(), 4u);
  EXPECT_EQ(stroke_of(second.to_log)->part, 0u);
  send(comb_at(3, "k", 2, false), false);
  const LiveStroke::Plan fourth = send(comb_at(4, "k", 3, true));
  EXPECT_TRUE(fourth.joins);
  EXPECT_EQ(stroke_of(fourth.to_log)->samples.size(), 4u);
  EXPECT_EQ(stroke_of(fourth.to_log)->part, 1u);
  EXPECT_EQ(stroke_of(fourth.merged)->samples.size(), 8u);
}

TEST_F(LiveStrokeTest, PartsComeInOrder) {
  EXPECT_EQ(refusal(comb_at(1, "k", 2, false)).limit, "the next part is 0");
  send(comb_at(1, "k", 0, false));
  const Status skipped = refusal(comb_at(1, "k", 2, false));
  EXPECT_EQ(skipped.code, Code::invalid);
  EXPECT_EQ(skipped.pointer, "/stroke/part");
  EXPECT_EQ(skipped.limit, "the next part is 1");
  EXPECT_EQ(refusal(comb_at(1, "k", 0, false)).limit, "the next part is 1");
}

TEST_F(LiveStrokeTest, NothingFollowsTheLastPart) {
  send(comb_at(1, "k", 0, false));
  send(comb_at(1, "k", 1, true));
  EXPECT_EQ(refusal(comb_at(1, "k", 2, false)).code, Code::conflict);
}

TEST_F(LiveStrokeTest, PartsRepeatToolAndBrush) {
  send(comb_at(1, "k", 0, false));
  Comb wider = comb_at(2, "k", 1, false);
  wider.brush.radius *= 2;
  EXPECT_EQ(refusal(wider).code, Code::invalid);
  Blow blow;
  blow.stroke = comb_at(2, "k", 1, false).stroke;
  EXPECT_EQ(refusal(blow).code, Code::invalid);
}

TEST_F(LiveStrokeTest, TimeRunsOnAndSamplesAreCounted) {
  Comb late = comb_at(1, "k", 0, false);
  for (StrokeSample& sample : late.stroke->samples) sample.time = 3;
  send(late);
  EXPECT_EQ(refusal(comb_at(1, "k", 1, false)).pointer, "/stroke/samples/0/time");
  late.stroke->part = 1;
  late.stroke->samples.resize(9'999, late.stroke->samples.front());
  EXPECT_EQ(refusal(late).pointer, "/stroke/samples");
}

TEST_F(LiveStrokeTest, AnotherChangeEndsTheStrokeAndAMissDoesNot) {
  send(comb_at(1, "k", 0, false));
  send(comb_at(5), false);
  EXPECT_TRUE(refusal(comb_at(2, "k", 1, false)).ok());
  send(comb_at(5), true);
  EXPECT_EQ(refusal(comb_at(2, "k", 1, false)).limit, "the next part is 0");
}

}  // namespace
}  // namespace pelage
