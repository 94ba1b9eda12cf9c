// A stroke across the picture is covered by a few boxes along it, with nothing of it left out.
#include "renderer/upload/cover_boxes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace pelage {
namespace {

ClipBox square(glm::vec2 middle, float half) { return {middle - half, middle + half}; }

float area_of(const std::vector<ClipBox>& boxes) {
  float sum = 0;
  for (const ClipBox& box : boxes) sum += (box.high.x - box.low.x) * (box.high.y - box.low.y);
  return sum;
}

std::vector<ClipBox> diagonal() {
  std::vector<ClipBox> boxes;
  for (int i = 0; i <= 20; ++i) boxes.push_back(square(glm::vec2(-0.5f + 0.05f * static_cast<float>(i)), 0.06f));
  return boxes;
}

TEST(CoverBoxes, AStrokeAcrossThePictureIsCutAlongItsWay) {
  EXPECT_EQ(cover(diagonal(), 1).size(), 1u);
  EXPECT_LT(area_of(cover(diagonal(), 2)), 0.65f * area_of(cover(diagonal(), 1)));
  EXPECT_EQ(cover(diagonal(), 4).size(), 4u);
  EXPECT_LT(area_of(cover(diagonal(), 4)), 0.4f * area_of(cover(diagonal(), 1)));
}

TEST(CoverBoxes, WhatLiesTogetherStaysTogether) {
  EXPECT_TRUE(cover({}, 4).empty());
  EXPECT_EQ(cover({square({0, 0}, 0.1f)}, 4).size(), 1u);
  std::vector<ClipBox> heap;
  for (int i = 0; i < 9; ++i) heap.push_back(square(0.05f * glm::vec2(i % 3, i / 3), 0.05f));
  EXPECT_EQ(cover(heap, 4).size(), 1u);
  EXPECT_EQ(cover(std::vector<ClipBox>(10'000, square({0, 0}, 0.1f)), 4).size(), 1u);
}

RC_GTEST_PROP(CoverBoxes, HoldEveryBox, ()) {
  const auto coordinate = [] { return 0.01f * static_cast<float>(*rc::gen::inRange(-150, 150)); };
  std::vector<ClipBox> boxes(*rc::gen::inRange<std::size_t>(1, 60));
  for (ClipBox& box : boxes) box = square({coordinate(), coordinate()}, 0.01f * static_cast<float>(*rc::gen::inRange(0, 60)));
  const auto most = *rc::gen::inRange<std::size_t>(1, 6);
  const std::vector<ClipBox> covers = cover(boxes, most);
  RC_ASSERT(!covers.empty() && covers.size() <= most);
  for (const ClipBox& box : boxes) {
    RC_ASSERT(std::any_of(covers.begin(), covers.end(), [&](const ClipBox& cover) {
      return glm::all(glm::lessThanEqual(cover.low, box.low)) && glm::all(glm::greaterThanEqual(cover.high, box.high));
    }));
  }
}

}  // namespace
}  // namespace pelage
