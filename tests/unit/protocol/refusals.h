// Refusals of the decoder.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "protocol/json/decode.h"

namespace pelage {

inline std::string repeated(const std::string& text, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += (i ? "," : "") + text;
  return all;
}

inline Status refusal(std::string_view text) {
  const auto decoded = decode_commands(text);
  return decoded.ok() ? Status{} : decoded.status();
}

inline void expect_refusal(std::string_view text, Code code, std::string_view pointer) {
  const Status status = refusal(text);
  EXPECT_EQ(status.code, code) << text << "\n" << status.message;
  EXPECT_EQ(status.pointer, pointer) << text << "\n" << status.message;
}

}  // namespace pelage
