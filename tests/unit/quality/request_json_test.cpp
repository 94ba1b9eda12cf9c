// Budgets and error limits in requests, and estimates in answers.
#include <gtest/gtest.h>

#include "protocol/json/decode.h"
#include "protocol/json/encode.h"

namespace pelage {
namespace {

void expect_request_refused(const std::string& text, const std::string& pointer) {
  const auto decoded = decode_frame_request(text);
  ASSERT_FALSE(decoded.ok()) << text;
  EXPECT_EQ(decoded.status().code, Code::invalid) << text;
  EXPECT_EQ(decoded.status().pointer, pointer) << text;
  EXPECT_NE(decoded.status().limit, "") << text;
}

TEST(DialJson, RefusesTwoGoals) {
  expect_request_refused(R"({"budget_ms": 40, "quality": "draft"})", "/budget_ms");
  expect_request_refused(R"({"max_error": 0.1, "quality": "draft"})", "/max_error");
  expect_request_refused(R"({"budget_ms": 40, "max_error": 0.1})", "/max_error");
}

TEST(DialJson, RefusesGoalsOutOfRange) {
  for (const char* budget : {"0.99", "600001", "-1"})
    expect_request_refused(std::string(R"({"budget_ms": )") + budget + "}", "/budget_ms");
  for (const char* error : {"0", "1.01", "-1"})
    expect_request_refused(std::string(R"({"max_error": )") + error + "}", "/max_error");
  EXPECT_TRUE(decode_frame_request(R"({"budget_ms": 1})").ok());
  EXPECT_TRUE(decode_frame_request(R"({"budget_ms": 600000})").ok());
  EXPECT_TRUE(decode_frame_request(R"({"max_error": 1})").ok());
}

TEST(DialJson, ComesBack) {
  FrameRequest request;
  request.budget_ms = 33.25;
  const auto budget = decode_frame_request(encode(request));
  ASSERT_TRUE(budget.ok()) << budget.status().message;
  EXPECT_EQ(budget->budget_ms, 33.25);
  EXPECT_FALSE(budget->max_error);
  request.budget_ms.reset(), request.max_error = 0.02;
  const auto error = decode_frame_request(encode(request));
  ASSERT_TRUE(error.ok()) << error.status().message;
  EXPECT_EQ(error->max_error, 0.02);
  EXPECT_TRUE(error->plans());
}

TEST(DialJson, AddressesSayTheSame) {
  const auto request = decode_frame_query({{"budget_ms", "40"}});
  ASSERT_TRUE(request.ok());
  EXPECT_EQ(request->budget_ms, 40);
  EXPECT_EQ(decode_frame_query({{"max_error", "x"}}).status().pointer, "/max_error");
  EXPECT_EQ(decode_frame_query({{"budget_ms", "40"}, {"scale", "1"}}).status().pointer, "/budget_ms");
}

TEST(DialJson, EstimatesNameTheirReference) {
  const std::string text = encode(FrameEstimate{.error = 0.5, .end = PlanEnd::cheapest, .calibration = "defaults"});
  EXPECT_NE(text.find(R"("reference":"traced_strands")"), std::string::npos) << text;
  EXPECT_NE(text.find(R"("end":"cheapest")"), std::string::npos) << text;
}

}  // namespace
}  // namespace pelage
