// Hashed names of objects, and the order in which they cover a pixel.
#include "server/frames/cryptomatte.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace pelage {
namespace {

std::uint32_t bits_of(std::string_view name) { return std::bit_cast<std::uint32_t>(matte_id(name)); }

/// Published values of MurmurHash3_x86_32 with seed 0.
TEST(MatteId, HasThePublishedBits) {
  EXPECT_EQ(bits_of("test"), 0xba6bd213u);
  EXPECT_EQ(bits_of("Hello, world!"), 0xc0363e43u);
  EXPECT_EQ(bits_of("The quick brown fox jumps over the lazy dog"), 0x2e4ff723u);
}

TEST(MatteId, IsFiniteAndNormalForAnyName) {
  EXPECT_EQ(bits_of(""), 1u << 23) << "the hash is 0";
  for (int i = 0; i < 20'000; ++i) ASSERT_TRUE(std::isnormal(matte_id("coat/" + std::to_string(i)))) << i;
}

/// The Cryptomatte of one pixel, given the coverage of each object.
Cryptomatte matte_of(const FurFrame& frame, const std::vector<float>& shares) {
  std::vector<FloatImage> pictures(4, FloatImage{1, 1, std::vector<float>(4, 0)});
  for (std::size_t k = 0; k < shares.size(); ++k) pictures[k / 3].rgba[k % 3] = shares[k];
  return {frame, pictures};
}

TEST(Cryptomatte, HasMostFirstAndDropsTheRest) {
  FurFrame frame;
  frame.coats.assign(limits::coats, {});
  for (std::size_t k = 0; k < frame.coats.size(); ++k) frame.coats[k].name = std::to_string(k);
  const Cryptomatte matte =
      matte_of(frame, {0.05f, 0, 0.1f, 0.2f, 0.01f, 0.3f, 0.15f, 0.12f, 1e-6f, std::nanf(""), -0.5f});
  std::vector<float> found;
  for (const ExrPlane& plane : matte.planes()) found.push_back(plane.values[plane.offset]);
  EXPECT_EQ(found, (std::vector{matte_id("coat/2"), 0.3f, matte_id("coat/0"), 0.2f, matte_id("coat/3"), 0.15f,
                                matte_id("coat/4"), 0.12f, matte_id("curves"), 0.1f, matte_id("skin"), 0.05f}));
}

TEST(Cryptomatte, HasZeroesWhereThereIsNothingAndItsNamesAreText) {
  FurFrame frame;
  frame.coats[0].name = "a \"b\"\\";
  const Cryptomatte matte = matte_of(frame, {0, 1});
  std::vector<float> found;
  for (const ExrPlane& plane : matte.planes()) found.push_back(plane.values[plane.offset]);
  EXPECT_EQ(found[0], matte_id("eyes"));
  EXPECT_EQ(found[1], 1);
  EXPECT_EQ(std::count(found.begin(), found.end(), 0.0f), 10);
  const std::string manifest = matte.texts().back().value;
  EXPECT_NE(manifest.find(R"("coat/a \"b\"\\":")"), manifest.npos) << manifest;
}

}  // namespace
}  // namespace pelage
