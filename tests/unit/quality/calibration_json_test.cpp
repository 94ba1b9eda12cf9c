// Calibration files.
#include <gtest/gtest.h>

#include "protocol/json/calibration.h"

namespace pelage {
namespace {

const Calibration calibration{"2001-02-03", "a \"GL\"", 3, 0.4};

void expect_refusal(std::string text, const std::string& from, const std::string& to, const std::string& pointer) {
  const std::size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  const auto decoded = decode_calibration(text.replace(at, from.size(), to));
  ASSERT_FALSE(decoded.ok()) << text;
  EXPECT_EQ(decoded.status().pointer, pointer) << decoded.status().message;
}

TEST(CalibrationJson, ComesBack) {
  const auto decoded = decode_calibration(encode(calibration));
  ASSERT_TRUE(decoded.ok()) << decoded.status().message << decoded.status().pointer;
  EXPECT_EQ(*decoded, calibration);
}

TEST(CalibrationJson, WhatIsBrokenIsRefused) {
  EXPECT_FALSE(decode_calibration("").ok());
  EXPECT_FALSE(decode_calibration("{\"version\": 5").ok());
  expect_refusal("{}", "{}", "{}", "/version");
  expect_refusal(encode(calibration), "\"version\":5", "\"version\":4", "/version");
  expect_refusal(encode(calibration), "\"price\":0.4", "\"price\":0", "/price");
  expect_refusal(encode(calibration), "\"name\"", "\"nome\"", "/name");
}

}  // namespace
}  // namespace pelage
