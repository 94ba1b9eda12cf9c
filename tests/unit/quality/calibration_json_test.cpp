// Calibrations as files.
#include <gtest/gtest.h>

#include "protocol/json/calibration.h"
#include "tests/unit/quality/views.h"

namespace pelage {
namespace {

std::string changed(const std::string& from, const std::string& to) {
  std::string text = encode(testing::plain_calibration());
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}

void expect_refusal(const std::string& text, const std::string& pointer) {
  const auto decoded = decode_calibration(text);
  ASSERT_FALSE(decoded.ok()) << text;
  EXPECT_EQ(decoded.status().pointer, pointer) << decoded.status().message;
}

TEST(CalibrationJson, ComesBack) {
  Calibration calibration = testing::plain_calibration();
  calibration.machine = "a \"GL\"", calibration.threads = 3;
  const auto decoded = decode_calibration(encode(calibration));
  ASSERT_TRUE(decoded.ok()) << decoded.status().message << decoded.status().pointer;
  EXPECT_EQ(decoded->machine, calibration.machine);
  EXPECT_EQ(decoded->threads, 3);
  EXPECT_EQ(decoded->name, "by hand");
  EXPECT_EQ(decoded->cost, calibration.cost);
  ASSERT_EQ(decoded->ladder.size(), calibration.ladder.size());
  for (std::size_t i = 0; i < calibration.ladder.size(); ++i) {
    EXPECT_EQ(decoded->ladder[i].knobs, calibration.ladder[i].knobs);
    EXPECT_NEAR(decoded->ladder[i].log_error, calibration.ladder[i].log_error, 1e-5);
  }
}

TEST(CalibrationJson, WhatIsBrokenIsRefused) {
  EXPECT_FALSE(decode_calibration("").ok());
  EXPECT_FALSE(decode_calibration("{\"version\": 1").ok());
  expect_refusal("{}", "/version");
  expect_refusal(changed("\"version\":3", "\"version\":2"), "/version");
  expect_refusal(changed("\"cost\":[1.0,", "\"cost\":["), "/cost");
  expect_refusal(changed("\"cost\":[1.0,", "\"cost\":[-1.0,"), "/cost/0");
  expect_refusal(changed("\"learnt_safety\":1.0", "\"learnt_safety\":0"), "/learnt_safety");
  expect_refusal(changed("\"probe_safety\":1.0", "\"probe_safety\":0.9"), "/probe_safety");
  expect_refusal(changed("\"error_safety\":1.6", "\"error_safety\":0"), "/ladder/0/error_safety");
  expect_refusal(changed("\"shells\":4", "\"shells\":0"), "/ladder/0/knobs/shells");
  expect_refusal(changed("\"name\"", "\"nome\""), "/name");
}

}  // namespace
}  // namespace pelage
