// Frame ranges and file names.
#include <gtest/gtest.h>

#include "server/batch/frame_range.h"
#include "server/batch/output_pattern.h"

namespace pelage::testing {
namespace {

std::vector<int> frames(std::string_view text) {
  const auto parsed = parse_frames(text);
  EXPECT_TRUE(parsed.ok()) << text << ": " << parsed.status().message;
  return parsed ? *parsed : std::vector<int>();
}

TEST(FrameRanges, AreReadAsFarmsWriteThem) {
  EXPECT_EQ(frames("7"), std::vector<int>({7}));
  EXPECT_EQ(frames("1-4"), std::vector<int>({1, 2, 3, 4}));
  EXPECT_EQ(frames("1-10x4"), std::vector<int>({1, 5, 9}));
  EXPECT_EQ(frames("1-10:4"), std::vector<int>({1, 5, 9}));
  EXPECT_EQ(frames("9,1,4-5"), std::vector<int>({9, 1, 4, 5}));
  EXPECT_EQ(frames("-5--3"), std::vector<int>({-5, -4, -3}));
  EXPECT_EQ(frames("-2-2x2"), std::vector<int>({-2, 0, 2}));
  EXPECT_EQ(frames("0-999999").size(), 1'000'000u);
}

TEST(FrameRanges, RefuseTextsThatAreNoRange) {
  for (const char* text : {"", ",", "1,", "a", "1-", "4-1", "1-9x0", "1-9x-2", "1-9x", "1-4,3", "1 - 4", "1-4;", "1.5",
                           "99999999999", "1000001", "0-1000000", "--3", "1-4x1x1"}) {
    const auto parsed = parse_frames(text);
    ASSERT_FALSE(parsed.ok()) << text;
    EXPECT_EQ(parsed.status().pointer, "/frames") << text;
  }
}

TEST(FrameRanges, SayWhatIsWrong) {
  EXPECT_EQ(parse_frames("10-1").status().message, "\"10-1\" ends before it begins.");
  EXPECT_EQ(parse_frames("1-9x0").status().message, "\"1-9x0\" has a step below 1.");
  EXPECT_EQ(parse_frames("ten").status().message, "\"ten\" is no range of frames.");
}

TEST(OutputPatterns, NameEachFrame) {
  const auto pattern = OutputPattern::create("out/fox.####.exr", "/job", true);
  ASSERT_TRUE(pattern.ok());
  EXPECT_EQ(pattern->file(7), "/job/out/fox.0007.exr");
  EXPECT_EQ(pattern->file(-7), "/job/out/fox.-0007.exr");
  EXPECT_EQ(pattern->file(123456), "/job/out/fox.123456.exr");
  EXPECT_EQ(pattern->format(), FrameFormat::exr);
  EXPECT_EQ(OutputPattern::create("/there/#.png", "/job", true)->file(3), "/there/3.png");
  EXPECT_EQ(OutputPattern::create("one.png", "job", false)->file(3), "job/one.png");
}

TEST(OutputPatterns, RefuseNamesThatLoseFrames) {
  for (const char* text :
       {"", "fox", "fox.####", "fox.####.jpg", "fox.png", "f##x.##.png", "a#b/fox.####.png", ".png"}) {
    const auto pattern = OutputPattern::create(text, "job", true);
    ASSERT_FALSE(pattern.ok()) << text;
    EXPECT_EQ(pattern.status().pointer, "/output") << text;
  }
}

}  // namespace
}  // namespace pelage::testing
