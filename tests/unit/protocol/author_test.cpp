#include "protocol/json/author.h"

#include <gtest/gtest.h>

namespace pelage {
namespace {

using namespace std::string_literals;

TEST(Author, NamesOfUtf8AreTaken) {
  for (const std::string& name : {"a"s, "Zoë Ångström"s, "100%41"s, "羊毛"s, std::string(200, 'x')})
    EXPECT_TRUE(check_author(name).ok()) << name;
}

TEST(Author, WhatIsNoNameIsRefused) {
  for (const std::string& name :
       {""s, std::string(201, 'x'), "a\nb"s, "a\0b"s, "\x7f"s, "\xff"s, "\xc3"s, "\xed\xa0\x80"s}) {
    EXPECT_EQ(check_author(name).code, Code::malformed) << name;
    EXPECT_NE(check_author(name).limit.find("200 bytes"), std::string::npos);
  }
}

TEST(Author, TheHeaderHoldsAsciiAlone) {
  EXPECT_EQ(encoded_author("Ann-B._~9"), "Ann-B._~9");
  EXPECT_EQ(encoded_author("100%41 Zoë"), "100%2541%20Zo%C3%AB");
  EXPECT_EQ(encoded_author("\r\n"), "%0D%0A");
}

}  // namespace
}  // namespace pelage
