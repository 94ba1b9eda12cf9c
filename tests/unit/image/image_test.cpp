#include "renderer/image/image.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "renderer/picture_files/picture_files.h"

namespace pelage {
namespace {

constexpr std::size_t enough = 1 << 20;

Image gradient(int width, int height, bool opaque) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int alpha = opaque ? 255 : (x * 7 + y * 13) % 256;
      for (int value : {x * 5 % 256, y * 3 % 256, (x + y) % 256, alpha}) {
        image.rgba.push_back(static_cast<std::uint8_t>(value));
      }
    }
  }
  return image;
}

std::span<const std::byte> bytes_in(const std::string& text) { return std::as_bytes(std::span(text)); }

/// A minimal PNG whose header claims this size. Its checksum is right, its pixels are missing.
std::string png_header(std::uint32_t width, std::uint32_t height) {
  std::string png = encode_png(gradient(1, 1, true), true);
  const auto put = [&](std::size_t at, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i) png[at + i] = static_cast<char>(value >> (24 - 8 * i));
  };
  put(16, width);
  put(20, height);
  std::uint32_t crc = ~0u;
  for (std::size_t i = 12; i < 29; ++i) {
    crc ^= static_cast<std::uint8_t>(png[i]);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1 ? 0xedb88320u : 0u);
  }
  put(29, ~crc);
  return png;
}

TEST(Image, RoundTripKeepsEveryByteAlsoWhereAlphaIsZero) {
  Image image = gradient(37, 21, false);
  image.rgba[3] = 0;  // colour under alpha 0 must survive: alpha is straight
  image.rgba[0] = 200;
  const Result<Image> back = picture_files().decode_image(bytes_in(encode_png(image, true)), enough);
  ASSERT_TRUE(back.ok()) << back.status().message;
  EXPECT_EQ(back->width, 37);
  EXPECT_EQ(back->height, 21);
  EXPECT_EQ(back->rgba, image.rgba);
}

TEST(Image, TransparentPixelsAreKeptEvenWhenAlphaNeedNotBe) {
  const Image image = gradient(9, 9, false);
  const Result<Image> back = picture_files().decode_image(bytes_in(encode_png(image, false)), enough);
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(back->rgba, image.rgba);
}

TEST(Image, OpaqueImageBecomesRgb) {
  const Image image = gradient(16, 8, true);
  const std::string rgb = encode_png(image, false), rgba = encode_png(image, true);
  EXPECT_EQ(rgb[25], 2) << "PNG colour type of RGB";
  EXPECT_EQ(rgba[25], 6) << "PNG colour type of RGBA";
  EXPECT_EQ(picture_files().decode_image(bytes_in(rgb), enough)->rgba, image.rgba);
}

TEST(Image, CarriesTextAndSrgbAndIsDeterministic) {
  const std::array<ImageText, 1> texts = {ImageText{"pelage:revision", "12"}};
  const std::string png = encode_png(gradient(4, 4, true), false, texts);
  EXPECT_NE(png.find("tEXt"), std::string::npos);
  EXPECT_NE(png.find("pelage:revision"), std::string::npos);
  EXPECT_NE(png.find("sRGB"), std::string::npos);
  EXPECT_EQ(png.find("tIME"), std::string::npos);
  EXPECT_EQ(png, encode_png(gradient(4, 4, true), false, texts));
}

TEST(Image, EveryTruncationIsRefused) {
  const std::string png = encode_png(gradient(24, 24, false), true);
  const std::size_t pixels_end = png.find("IDAT") + 4;
  for (std::size_t length = 0; length < png.size() - 16; length += 7) {
    const Result<Image> result = picture_files().decode_image(bytes_in(png.substr(0, length)), enough);
    ASSERT_FALSE(result.ok()) << length << " of " << png.size() << ", pixels start at " << pixels_end;
    EXPECT_EQ(result.status().code, Code::invalid);
  }
}

TEST(Image, SizeIsCheckedBeforePixels) {
  const Result<Image> huge = picture_files().decode_image(bytes_in(png_header(0x7fffffff, 0x7fffffff)), enough);
  ASSERT_FALSE(huge.ok());
  EXPECT_EQ(huge.status().code, Code::invalid);
  const Result<Image> wide = picture_files().decode_image(bytes_in(png_header(50'000, 50'000)), enough);
  ASSERT_FALSE(wide.ok());
  EXPECT_NE(wide.status().message.find("at most 1048576"), std::string::npos) << wide.status().message;
  EXPECT_FALSE(picture_files().decode_image(bytes_in(encode_png(gradient(11, 10, true), true)), 109).ok());
  EXPECT_TRUE(picture_files().decode_image(bytes_in(encode_png(gradient(11, 10, true), true)), 110).ok());
}

TEST(Image, OtherBytesAreRefused) {
  EXPECT_FALSE(picture_files().decode_image({}, enough).ok());
  EXPECT_FALSE(picture_files().decode_image(bytes_in("GIF89a and so on"), enough).ok());
  EXPECT_FALSE(
      picture_files().decode_image(bytes_in("\xff\xd8\xff\xe0 not really a JPEG \xff\xda\xff\xd9"), enough).ok());
}

}  // namespace
}  // namespace pelage
