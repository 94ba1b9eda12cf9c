// Cost corrections start after a few frames, and change in steps.
#include "renderer/quality/cost_log.h"

#include <gtest/gtest.h>

#include <limits>

namespace pelage {
namespace {

void add_often(CostLog& log, std::uint64_t scene, double ratio, int times) {
  for (int i = 0; i < times; ++i) log.add(scene, 10, 10 * ratio);
}

TEST(CostLog, NothingIsCorrectedBeforeThreeFrames) {
  CostLog log;
  add_often(log, 1, 3, 2);
  EXPECT_EQ(log.correction(1), CostCorrection{});
  add_often(log, 1, 3, 1);
  EXPECT_NEAR(log.correction(1).factor, 3, 3 * 0.05);
  EXPECT_TRUE(log.correction(1).learnt);
  EXPECT_EQ(log.correction(2), CostCorrection{});
}

TEST(CostLog, SmallChangesChangeNothing) {
  CostLog log;
  add_often(log, 1, 1.07, 20);
  EXPECT_EQ(log.correction(1), (CostCorrection{1, true}));
  add_often(log, 1, 2, 20);
  const double once = log.correction(1).factor;
  add_often(log, 1, 2.1, 20), add_often(log, 1, 1.9, 20);
  EXPECT_EQ(log.correction(1).factor, once);
}

TEST(CostLog, AFewSlowFramesCorrectNothing) {
  CostLog log;
  add_often(log, 1, 1, 3), add_often(log, 1, 50, 2), add_often(log, 1, 1, 3);
  EXPECT_EQ(log.correction(1), (CostCorrection{1, true}));
}

TEST(CostLog, CorrectionsAreBoundedAndFinite) {
  CostLog log;
  add_often(log, 1, 1e12, 5), add_often(log, 2, 1e-12, 5);
  EXPECT_LE(log.correction(1).factor, CostLog::max * CostLog::step);
  EXPECT_GE(log.correction(2).factor, 1 / (CostLog::max * CostLog::step));
  log.add(3, 0, 1), log.add(3, 1, 0), log.add(3, 1, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(log.correction(3), CostCorrection{});
}

TEST(CostLog, OldScenesAreForgotten) {
  CostLog log;
  add_often(log, 1, 3, 3);
  for (std::uint64_t scene = 2; scene < 2 + CostLog::max_scenes; ++scene) log.add(scene, 1, 1);
  EXPECT_EQ(log.correction(1), CostCorrection{});
}

}  // namespace
}  // namespace pelage
