#include "server/http/request_log.h"

#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

namespace pelage {
namespace {

const std::string trace = "4bf92f3577b34da6a3ce929d0e0e4736";

TEST(RequestLog, ARequestWithoutATraceHasARandomId) {
  const std::string id = new_request_id("");
  EXPECT_TRUE(std::regex_match(id, std::regex("[0-9a-f]{16}"))) << id;
  EXPECT_NE(id, new_request_id(""));
}

TEST(RequestLog, TheTraceIdComesFirst) {
  for (const std::string& parent :
       std::vector<std::string>{"00-" + trace + "-00f067aa0ba902b7-01", "01-" + trace + "-00f067aa0ba902b7-01-more"}) {
    const std::string id = new_request_id(parent);
    EXPECT_TRUE(std::regex_match(id, std::regex(trace + "-[0-9a-f]{16}"))) << id;
  }
}

TEST(RequestLog, WhatIsNoTraceIsLeftOut) {
  for (const std::string& parent : std::vector<std::string>{
           "ff-" + trace + "-00f067aa0ba902b7-01", "00-" + trace + "-00f067aa0ba902b7-01-more",
           "00-" + trace + "-00f067aa0ba902b7", "00-" + std::string(32, '0') + "-00f067aa0ba902b7-01",
           "00-" + trace + "-0000000000000000-01", "00-4BF92F3577B34DA6A3CE929D0E0E4736-00f067aa0ba902b7-01", trace,
           std::string("00-\r\n"), "00-" + trace + "00f067aa0ba902b7--01"}) {
    EXPECT_EQ(new_request_id(parent).size(), 16u) << parent;
  }
}

}  // namespace
}  // namespace pelage
