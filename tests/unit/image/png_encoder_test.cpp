#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <thread>
#include <vector>

#include "renderer/image/png.h"

namespace pelage {
namespace {

constexpr std::array<std::array<int, 2>, 6> sizes{{{64, 80}, {64, 79}, {80, 64}, {1, 1}, {33, 16}, {16, 33}}};

Image noise(int width, int height, std::uint32_t seed, bool opaque) {
  Image image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(4 * width * height))};
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    seed = seed * 1664525 + 1013904223;
    image.rgba[i] = opaque && i % 4 == 3 ? 255 : static_cast<std::uint8_t>(seed >> 24);
  }
  return image;
}

/// Encodes what a client requests: pictures of a few sizes, each mostly equal to the one before.
RC_GTEST_PROP(PngEncoder, GivesTheBytesThatEncodingWithoutAMemoryGives, ()) {
  PngEncoder encoder(2, 20'000);  // keeps three or four of the larger pictures
  std::vector<Image> pictures;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    pictures.push_back(noise(sizes[i][0], sizes[i][1], static_cast<std::uint32_t>(i), i != 2));
  }
  for (int frame = 0; frame < 40; ++frame) {
    Image& image = pictures[*rc::gen::inRange<std::size_t>(0, pictures.size())];
    const auto changed = *rc::gen::inRange<std::size_t>(0, 3);
    for (std::size_t i = 0; i < changed; ++i) image.rgba[*rc::gen::inRange<std::size_t>(0, image.rgba.size())] ^= 1;
    const bool keep_alpha = *rc::gen::arbitrary<bool>();
    RC_ASSERT(encoder.encode(image, keep_alpha) == encode_png(image, keep_alpha));
  }
}

TEST(PngEncoder, PicturesTooLargeToKeepAreEncodedAllTheSame) {
  PngEncoder encoder(2, 63 * 80);
  const Image large = noise(64, 80, 1, true), small = noise(16, 33, 2, true);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(encoder.encode(large, false), encode_png(large, false));
    EXPECT_EQ(encoder.encode(small, false), encode_png(small, false));
  }
}

TEST(PngEncoder, ServesSeveralThreads) {
  PngEncoder encoder(2);
  std::array<int, 4> wrong{};
  std::vector<std::thread> threads;
  for (std::uint32_t t = 0; t < wrong.size(); ++t) {
    threads.emplace_back([&, t] {
      Image image = noise(64, 80, t % 2, true);
      const std::string expected = encode_png(image, false);
      for (int i = 0; i < 50; ++i) wrong[t] += encoder.encode(image, false) != expected;
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, (std::array<int, 4>{}));
}

}  // namespace
}  // namespace pelage
