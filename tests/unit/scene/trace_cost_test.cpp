#include "server/frames/trace_cost.h"

#include <gtest/gtest.h>

namespace pelage::trace_cost_test {
namespace {

FrameRequest strands_of(int size, int passes) {
  FrameRequest request;
  request.width = request.height = size;
  request.knobs.method = Method::strands;
  request.knobs.trace.passes = passes;
  return request;
}

/// The report of a probe of 2 passes.
TraceReport report() {
  TraceReport report;
  report.grow_ms = 500, report.trace_ms = 40;
  return report;
}

TEST(TraceCostTest, GrowsOnceAndPaysForEachPassAndPixel) {
  EXPECT_DOUBLE_EQ(trace_cost(strands_of(256, 4), report()).seconds, .5 + 4 * .02 * 16);
  EXPECT_DOUBLE_EQ(trace_cost(strands_of(256, 400), report()).seconds, .5 + 400 * .02 * 16);
  EXPECT_DOUBLE_EQ(trace_cost(strands_of(1, 1), report()).seconds, .5 + .02);
}

TEST(TraceCostTest, ACropPaysForItsShare) {
  FrameRequest request = strands_of(256, 4);
  request.crop = Crop{.left = 0, .top = 64, .width = 128, .height = 64};
  EXPECT_DOUBLE_EQ(trace_cost(request, report()).seconds, .5 + 4 * .02 * 16 / 8);
}

TEST(TraceCostTest, NeverExceedsItsOwnSeconds) {
  FrameRequest request = strands_of(8192, 65536);
  EXPECT_GT(trace_cost(request, report()).seconds, 1e4);
  request.knobs.trace.seconds = .5;
  EXPECT_DOUBLE_EQ(trace_cost(request, report()).seconds, .5);
}

TEST(TraceCostTest, AProbeIsSmallUncroppedAndHasNoView) {
  FrameRequest request = strands_of(256, 400);
  request.height = 3;
  request.crop = Crop{.left = 8, .top = 1, .width = 16, .height = 1};
  request.knobs.trace.noise = .01, request.knobs.trace.seconds = 5;
  request.view = "artist";
  const FrameRequest probe = probe_of(request);
  EXPECT_EQ(probe.width, 64);
  EXPECT_EQ(probe.height, 1);
  EXPECT_FALSE(probe.crop);
  EXPECT_EQ(probe.knobs.trace.passes, 2);
  EXPECT_EQ(probe.knobs.trace.noise, 0);
  EXPECT_EQ(probe.knobs.trace.seconds, 0);
  EXPECT_EQ(probe.view, "");
}

}  // namespace
}  // namespace pelage::trace_cost_test
