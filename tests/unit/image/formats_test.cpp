// Writes 16-bit PNG, JPEG and EXR, and reads pictures as linear light.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <regex>

#include "base/colour_space.h"
#include "renderer/image/float_image.h"
#include "renderer/picture_files/picture_files.h"

namespace pelage {
namespace {

constexpr std::size_t plenty = 1 << 20;
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text)); }

FloatImage decoded(const std::string& bytes) {
  const Result<FloatImage> image = picture_files().decode_float_image(bytes_of(bytes), plenty);
  EXPECT_TRUE(image.ok()) << image.status().message;
  return image.ok() ? *image : FloatImage{};
}

Image smooth(int width, int height) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int value : {x * 4, y * 4, 128, 255}) image.rgba.push_back(static_cast<std::uint8_t>(value % 256));
    }
  }
  return image;
}

TEST(Srgb, CurveHasItsPublishedValuesAndAnInverse) {
  EXPECT_NEAR(linear_from_srgb(0.5), 0.21404114, 1e-8);
  EXPECT_NEAR(srgb_from_linear(0.18), 0.46135613, 1e-8);
  for (double v : {0.0, 0.001, 0.04045, 0.2, 0.7, 1.0}) EXPECT_NEAR(srgb_from_linear(linear_from_srgb(v)), v, 1e-7);
}

TEST(Png16, KeepsEverySampleThatEightBitsWouldLose) {
  Image16 image{256, 3, {}};
  for (std::uint32_t i = 0; i < 256 * 3; ++i) {
    for (std::uint32_t v : {i * 85, i * 31 + 7, i * 3, 65535u}) image.rgba.push_back(static_cast<std::uint16_t>(v));
  }
  const std::string png = encode_png(image, false);
  EXPECT_EQ(png[24], 16) << "bits a sample";
  EXPECT_EQ(png[25], 2) << "RGB: every alpha is at its largest";
  const FloatImage back = decoded(png);
  ASSERT_EQ(back.rgba.size(), image.rgba.size());
  EXPECT_TRUE(back.display_referred);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_EQ(std::lround(srgb_from_linear(back.rgba[i + k]) * 65535), image.rgba[i + k]);
    }
  }
}

TEST(Png16, KeepsAlpha) {
  const Image16 image{1, 1, {65535, 0, 0, 13107}};
  const FloatImage back = decoded(encode_png(image, false));
  EXPECT_NEAR(back.rgba[3], 0.2f, 1e-6f);
  EXPECT_NEAR(back.rgba[0], 0.2f, 1e-6f) << "linear light is multiplied by alpha";
}

TEST(Jpeg, QualityTradesSizeForLikeness) {
  const Image image = smooth(64, 64);
  const auto error = [&](const Image& other) {
    int sum = 0;
    for (std::size_t i = 0; i < image.rgba.size(); ++i) sum += std::abs(image.rgba[i] - other.rgba[i]);
    return sum / static_cast<double>(image.rgba.size());
  };
  const std::string good = picture_files().encode_jpeg(image, 95), poor = picture_files().encode_jpeg(image, 20);
  EXPECT_GT(good.size(), poor.size());
  const Result<Image> of_good = picture_files().decode_image(bytes_of(good), plenty),
                      of_poor = picture_files().decode_image(bytes_of(poor), plenty);
  ASSERT_TRUE(of_good.ok() && of_poor.ok());
  EXPECT_LT(error(*of_good), 2);
  EXPECT_LT(error(*of_good), error(*of_poor));
  EXPECT_EQ(good, picture_files().encode_jpeg(image, 95));
  EXPECT_FALSE(picture_files().encode_jpeg(image, 1).empty());
  EXPECT_FALSE(picture_files().encode_jpeg(Image{1, 1, {9, 8, 7, 255}}, 100).empty());
}

const std::vector<float> extremes = {0, -0.0f, 1, -3.5f, 65504, 1e-3f, infinity, -infinity, nan, 1e-30f, 3e38f, 0.1f};

TEST(Exr, SingleFloatsKeepEveryBit) {
  const std::vector<ExrPlane> planes = {{"R", extremes, 0, 1, ExrSample::single},
                                        {"G", extremes, 0, 1, ExrSample::single},
                                        {"B", extremes, 0, 1, ExrSample::single}};
  const FloatImage back = decoded(picture_files().encode_exr({4, 3}, planes));
  ASSERT_EQ(back.width, 4);
  ASSERT_EQ(back.height, 3);
  EXPECT_FALSE(back.display_referred);
  for (std::size_t i = 0; i < extremes.size(); ++i) {
    EXPECT_EQ(std::memcmp(&back.rgba[i * 4], &extremes[i], sizeof(float)), 0) << extremes[i];
    EXPECT_EQ(back.rgba[i * 4 + 3], 1) << "no alpha in the file";
  }
}

TEST(Exr, HalfRoundsKeepsInfinityAndHoldsWhatIsTooLarge) {
  const std::vector<ExrPlane> planes = {{"Y", extremes}};
  const FloatImage back = decoded(picture_files().encode_exr({4, 3}, planes));
  ASSERT_EQ(back.rgba.size(), 48u);
  const auto grey = [&](std::size_t i) { return back.rgba[i * 4 + 1]; };
  EXPECT_EQ(grey(3), -3.5f);
  EXPECT_EQ(grey(4), 65504);
  EXPECT_EQ(grey(6), infinity);
  EXPECT_EQ(grey(7), -infinity);
  EXPECT_TRUE(std::isnan(grey(8)));
  EXPECT_EQ(grey(10), 65504) << "a finite number must not become infinite";
  EXPECT_NEAR(grey(11), 0.1f, 5e-5f);
}

TEST(Exr, KeepsAovsOfMixedTypes) {
  const std::vector<float> beauty = {1, 2, 3, 0.5f, 5, 6, 7, 1}, depth = {1e-7f, 123456.789f}, normal = {0.25f, -1};
  std::vector<ExrPlane> planes = rgba_planes(beauty, ExrSample::half, "beauty");
  planes.push_back({"Z", depth, 0, 1, ExrSample::single});
  planes.push_back({"normal.X", normal});
  const std::vector<ImageText> texts = {{"pelage:revision", "12"}};
  const std::string exr = picture_files().encode_exr({2, 1}, planes, texts);
  for (const char* name : {"beauty.R", "beauty.A", "normal.X", "pelage:revision"}) {
    EXPECT_NE(exr.find(name), std::string::npos) << name;
  }
  const FloatImage back = decoded(exr);
  EXPECT_EQ(back.rgba, beauty) << "the first layer with colour, multiplied by alpha as it was";
}

TEST(Exr, PlainColourGoesBeforeAnAov) {
  const std::vector<float> plain = {1, 2, 3, 1}, aov = {4, 5, 6, 1};
  std::vector<ExrPlane> planes = rgba_planes(aov, ExrSample::single, "albedo");
  for (const ExrPlane& plane : rgba_planes(plain, ExrSample::single)) planes.push_back(plane);
  EXPECT_EQ(decoded(picture_files().encode_exr({1, 1}, planes)).rgba, plain);
}

TEST(Exr, SameInputSameBytes) {
  const std::vector<float> rgba(16 * 9 * 4, 0.3f);
  const auto planes = rgba_planes(rgba, ExrSample::half);
  const std::string exr = picture_files().encode_exr({16, 9}, planes);
  EXPECT_EQ(exr, picture_files().encode_exr({16, 9}, planes));
  EXPECT_FALSE(std::regex_search(exr, std::regex("[0-9]{4}:[0-9]{2}:[0-9]{2} "))) << "a date would differ tomorrow";
}

TEST(Exr, WithoutColourOrCutOffIsRefused) {
  std::vector<float> values(64 * 64);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::sin(static_cast<float>(i * i));
  const std::vector<ExrPlane> depth = {{"Z", values}}, grey = {{"Y", values}};
  const std::string no_colour = picture_files().encode_exr({64, 64}, depth),
                    whole = picture_files().encode_exr({64, 64}, grey);
  EXPECT_FALSE(picture_files().decode_float_image(bytes_of(no_colour), plenty).ok());
  for (std::size_t length = 0; length < whole.size(); length += 97) {
    const Result<FloatImage> result = picture_files().decode_float_image(bytes_of(whole.substr(0, length)), plenty);
    ASSERT_FALSE(result.ok()) << length << " of " << whole.size();
    EXPECT_EQ(result.status().code, Code::invalid);
  }
  EXPECT_FALSE(picture_files().decode_float_image(bytes_of(whole), 64 * 64 - 1).ok());
  EXPECT_TRUE(picture_files().decode_float_image(bytes_of(whole), 64 * 64).ok());
}

/// Radiance RGBE without run lengths: value = mantissa / 256 * 2^(exponent - 128).
TEST(Hdr, ReadsRadiance) {
  std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n";
  for (int byte : {128, 64, 32, 129, 200, 100, 50, 140}) hdr += static_cast<char>(byte);
  const FloatImage image = decoded(hdr);
  ASSERT_EQ(image.width, 2);
  EXPECT_NEAR(image.rgba[0], 1.0f, 0.01f);
  EXPECT_NEAR(image.rgba[1], 0.5f, 0.01f);
  EXPECT_NEAR(image.rgba[4], 3200, 20);
  EXPECT_EQ(image.rgba[7], 1);
  EXPECT_FALSE(image.display_referred);
  EXPECT_FALSE(picture_files().decode_float_image(bytes_of(hdr.substr(0, hdr.size() - 3)), plenty).ok());
}

TEST(FloatReading, ReadsEightBitsAndRefusesOtherBytes) {
  const Image image{1, 1, {188, 0, 255, 51}};
  const FloatImage of_png = decoded(encode_png(image, true)), direct = linear_image(image);
  EXPECT_EQ(of_png.rgba, direct.rgba);
  EXPECT_NEAR(direct.rgba[2], 0.2f, 1e-6f);
  EXPECT_FALSE(picture_files().decode_float_image(bytes_of("GIF89a"), plenty).ok());
  EXPECT_FALSE(picture_files().decode_float_image({}, plenty).ok());
}

}  // namespace
}  // namespace pelage
