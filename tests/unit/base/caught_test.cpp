#include "base/caught.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace pelage {
namespace {

TEST(Caught, ExceptionsBecomeAStatus) {
  const auto out_of_memory = []() -> Result<int> { throw std::bad_alloc(); };
  EXPECT_EQ(caught(out_of_memory).status().code, Code::unavailable);
  const auto fails = []() -> Status { throw std::runtime_error("the cause"); };
  EXPECT_EQ(caught(fails).code, Code::internal);
  EXPECT_NE(caught(fails).message.find("the cause"), std::string::npos);
  const auto throws_a_number = []() -> Status { throw 7; };
  EXPECT_EQ(caught(throws_a_number).code, Code::internal);
}

TEST(Caught, WhatIsReturnedStays) {
  EXPECT_EQ(*caught([] { return Result<int>(3); }), 3);
  EXPECT_TRUE(caught([] { return Status{}; }).ok());
}

}  // namespace
}  // namespace pelage
