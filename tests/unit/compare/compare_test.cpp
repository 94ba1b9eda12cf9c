// The picture comparison as a whole: what it refuses, and that worse pictures have larger errors.
#include "renderer/compare/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "base/colour_space.h"
#include "tests/unit/compare/pictures.h"

namespace pelage {
namespace {

using namespace pictures;

PictureError measured(const FloatImage& reference, const FloatImage& test, const Mask& mask,
                      const CompareOptions& options = {}) {
  const Result<PictureError> error = compare(reference, test, mask, options);
  EXPECT_TRUE(error.ok()) << error.status().message;
  return error.ok() ? *error : PictureError{};
}

PictureFigures figures(const FloatImage& reference, const FloatImage& test, const Mask& mask,
                       const CompareOptions& options = {}) {
  const PictureError error = measured(reference, test, mask, options);
  EXPECT_TRUE(error.figures.has_value());
  return error.figures.value_or(PictureFigures{});
}

PictureFigures figures(const Image& reference, const Image& test) {
  return figures(linear_image(reference), linear_image(test), everywhere(reference.width, reference.height));
}

FloatImage constant(int width, int height, float r, float g, float b, float a = 1) {
  FloatImage image{width, height, {}};
  for (int i = 0; i < width * height; ++i) image.rgba.insert(image.rgba.end(), {r, g, b, a});
  return image;
}

TEST(Compare, EqualPicturesHaveNoErrorAtAll) {
  const Image image = cut_to_disc(noise(64, 64, 5), 20);
  const FloatImage linear = linear_image(image);
  const PictureError error = measured(linear, linear, alpha_mask(linear));
  ASSERT_TRUE(error.figures);
  EXPECT_EQ(error.figures->flip.mean, 0);
  EXPECT_EQ(error.figures->flip.percentile_95, 0);
  ASSERT_TRUE(error.figures->silhouette);
  EXPECT_EQ(error.figures->silhouette->mean, 0);
  EXPECT_EQ(error.figures->rel_mse, 0);
  EXPECT_EQ(error.figures->rmse, 0);
  EXPECT_EQ(error.figures->bias, 0);
}

TEST(Compare, LinearFiguresAgreeWithOnesComputedByHand) {
  const FloatImage reference = constant(4, 4, 0.5f, 0.2f, 0), test = constant(4, 4, 0.6f, 0.2f, 0.1f);
  const PictureFigures f = figures(reference, test, everywhere(4, 4));
  EXPECT_NEAR(f.rmse, std::sqrt((0.01 + 0.01) / 3), 1e-7);
  EXPECT_NEAR(f.rel_mse, (0.01 / (0.25 + 0.01) + 0.01 / 0.01) / 3, 1e-6);
  EXPECT_NEAR(f.bias, 0.1 * 0.2126 + 0.1 * 0.0722, 1e-7);
  EXPECT_NEAR(f.reference_luminance, 0.5 * 0.2126 + 0.2 * 0.7152, 1e-7);
  EXPECT_NEAR(figures(test, reference, everywhere(4, 4)).bias, -f.bias, 1e-12);
}

using Spoil = std::function<Image(const Image&, double)>;

Image with_noise(const Image& image, double amount) {
  return drawn(image.width, image.height, [&](int x, int y, int k) {
    const std::size_t i = static_cast<std::size_t>((y * image.width + x) * 4 + k);
    const double random = hash(static_cast<std::uint32_t>(i)) / 4294967296.0 - 0.5;
    return std::clamp<int>(static_cast<int>(std::lround(image.rgba[i] + 255 * amount * random)), 0, 255);
  });
}

Image with_blur(const Image& image, double sigma) {
  return drawn(image.width, image.height, [&](int x, int y, int k) {
    double sum = 0, weights = 0;
    for (int dy = -8; dy <= 8; ++dy) {
      for (int dx = -8; dx <= 8; ++dx) {
        const int u = std::clamp(x + dx, 0, image.width - 1), v = std::clamp(y + dy, 0, image.height - 1);
        const double weight = std::exp(-(dx * dx + dy * dy) / (2 * sigma * sigma));
        sum += weight * image.rgba[static_cast<std::size_t>((v * image.width + u) * 4 + k)];
        weights += weight;
      }
    }
    return std::lround(sum / weights);
  });
}

Image with_shift(const Image& image, double pixels) {
  return drawn(image.width, image.height, [&](int x, int y, int k) {
    const int u = std::max(x - static_cast<int>(pixels), 0);
    return image.rgba[static_cast<std::size_t>((y * image.width + u) * 4 + k)];
  });
}

Image with_exposure(const Image& image, double stops) {
  return drawn(image.width, image.height, [&](int x, int y, int k) {
    const double value = image.rgba[static_cast<std::size_t>((y * image.width + x) * 4 + k)] / 255.0;
    return std::lround(255 * srgb_from_linear(linear_from_srgb(value) * std::exp2(-stops)));
  });
}

TEST(Compare, ErrorsGrowWithTheDamage) {
  const Image image = scene(96, 96);
  const std::pair<Spoil, std::vector<double>> spoils[] = {{with_noise, {0.02, 0.05, 0.1, 0.3}},
                                                          {with_blur, {0.5, 1, 2, 3}},
                                                          {with_shift, {1, 2, 3}},
                                                          {with_exposure, {0.1, 0.3, 0.6, 1.2}}};
  for (const auto& [spoil, amounts] : spoils) {
    PictureFigures last;
    for (double amount : amounts) {
      const PictureFigures now = figures(image, spoil(image, amount));
      EXPECT_GT(now.flip.mean, last.flip.mean) << amount;
      EXPECT_GE(now.flip.percentile_95, last.flip.percentile_95) << amount;
      EXPECT_GT(now.rmse, last.rmse) << amount;
      EXPECT_GT(now.rel_mse, last.rel_mse) << amount;
      last = now;
    }
  }
}

TEST(Compare, OnePixelThatIsNotFiniteStopsEverything) {
  constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  const FloatImage good = constant(64, 64, 0.3f, 0.3f, 0.3f);
  for (float bad : {nan, inf, -inf}) {
    for (std::size_t channel : {0u, 2u, 3u}) {
      FloatImage broken = good;
      broken.rgba[4 * 1000 + channel] = bad;
      for (const PictureError& error :
           {measured(good, broken, everywhere(64, 64)), measured(broken, good, everywhere(64, 64)),
            measured(broken, broken, everywhere(64, 64))}) {
        EXPECT_EQ(error.non_finite, 1u);
        EXPECT_FALSE(error.figures) << "one NaN must not drown in a mean";
        EXPECT_TRUE(error.flip.empty());
      }
    }
  }
  FloatImage outside = good;
  outside.rgba[0] = nan;
  Mask mask = everywhere(64, 64);
  mask.inside[0] = 0;
  EXPECT_EQ(measured(good, outside, mask).non_finite, 1u) << "also outside the mask";
}

TEST(Compare, HugeAndNegativeLightStaysFinite) {
  const FloatImage huge = constant(8, 8, 3e38f, -3e38f, 1e-38f, 1e-30f), dark = constant(8, 8, 0, -1, 0, 2);
  const PictureFigures f = figures(dark, huge, everywhere(8, 8));
  for (double value : {f.flip.mean, f.flip.percentile_95, f.rel_mse, f.rmse, f.bias, f.reference_luminance}) {
    EXPECT_TRUE(std::isfinite(value)) << value;
  }
  EXPECT_LE(f.flip.percentile_95, 1);
}

TEST(Compare, RefusesWhatCannotBeCompared) {
  const FloatImage a = constant(8, 8, 0, 0, 0), b = constant(8, 9, 0, 0, 0);
  const Result<PictureError> sizes = compare(a, b, everywhere(8, 8));
  ASSERT_FALSE(sizes.ok());
  EXPECT_EQ(sizes.status().code, Code::invalid);
  EXPECT_NE(sizes.status().message.find("8 x 9"), std::string::npos) << sizes.status().message;
  EXPECT_FALSE(compare(a, a, everywhere(9, 8)).ok());
  Mask empty = everywhere(8, 8);
  std::fill(empty.inside.begin(), empty.inside.end(), 0);
  EXPECT_FALSE(compare(a, a, empty).ok());
  for (double bad : {0.0, -1.0, 1e9, std::nan("")}) {
    EXPECT_FALSE(compare(a, a, everywhere(8, 8), {.pixels_per_degree = bad}).ok()) << bad;
    EXPECT_EQ(compare(a, a, everywhere(8, 8), {.background = bad}).ok(), bad == 0) << bad;
    EXPECT_EQ(compare(a, a, everywhere(8, 8), {.silhouette = bad}).ok(), bad == 0) << bad;
  }
}

TEST(Compare, OnlyTheMaskCounts) {
  const Image reference = scene(96, 96);
  Image test = reference;
  for (std::size_t i = 0; i < 96 * 20 * 4; ++i) test.rgba[i] = static_cast<std::uint8_t>(255 - test.rgba[i]);
  Mask away = everywhere(96, 96);  // outside the reach of the filters, 10 pixels
  std::fill(away.inside.begin(), away.inside.begin() + 96 * 31, 0);
  const PictureError error = measured(linear_image(reference), linear_image(test), away);
  ASSERT_TRUE(error.figures);
  EXPECT_EQ(error.figures->flip.mean, 0);
  EXPECT_EQ(error.figures->rmse, 0);
  EXPECT_NEAR(error.coverage, 65.0 / 96, 1e-12);
  EXPECT_EQ(error.pixels, 96u * 65);
  EXPECT_GT(figures(reference, test).flip.mean, 0.1);
}

TEST(Compare, TheSilhouetteSeesTheSilhouetteAndNotTheInside) {
  const Image fur = cut_to_disc(strands(160, 160, 0), 60);
  const auto spoilt = [&](double from, double to) {
    Image image = fur;
    for (int y = 0; y < 160; ++y) {
      for (int x = 0; x < 160; ++x) {
        const double radius = std::hypot(x - 80, y - 80);
        std::uint8_t* p = &image.rgba[static_cast<std::size_t>((y * 160 + x) * 4)];
        if (radius >= from && radius < to) p[0] = p[1] = p[2] = 255;
      }
    }
    return image;
  };
  const FloatImage reference = linear_image(fur);
  const PictureFigures inside = figures(reference, linear_image(spoilt(0, 20)), alpha_mask(reference));
  const PictureFigures rim = figures(reference, linear_image(spoilt(57, 61)), alpha_mask(reference));
  ASSERT_TRUE(inside.silhouette && rim.silhouette);
  EXPECT_GT(inside.flip.mean, 0.05);
  EXPECT_EQ(inside.silhouette->mean, 0);
  EXPECT_GT(rim.silhouette->mean, 2 * rim.flip.mean) << "the whole hides what the silhouette shows";
  EXPECT_FALSE(figures(fur, fur).silhouette) << "a mask without an edge has no silhouette";
}

TEST(Compare, TransparentPixelsHaveNoColourOfTheirOwn) {
  Image a = cut_to_disc(scene(64, 64), 20), b = a;
  for (std::size_t i = 0; i < b.rgba.size(); i += 4) {
    if (b.rgba[i + 3] == 0) b.rgba[i] = b.rgba[i + 1] = 255;
  }
  EXPECT_EQ(figures(a, b).flip.mean, 0);
  EXPECT_GT(figures(a, cut_to_disc(a, 25)).flip.mean, 0) << "a change of alpha shows";
}

TEST(Compare, FloatPicturesAreToneMappedAndDisplayReferredOnesAreNot) {
  const FloatImage one = constant(16, 16, 1.5f, 1.5f, 1.5f), two = constant(16, 16, 3, 3, 3);
  const Mask mask = everywhere(16, 16);
  EXPECT_GT(figures(one, two, mask).flip.mean, 0.02) << "the shoulder keeps highlights apart";
  EXPECT_EQ(figures(one, two, mask, {.tone_map = ToneMap::none}).flip.mean, 0) << "both are white";
  EXPECT_EQ(figures(one, two, mask, {.tone_map = ToneMap::none}).bias, figures(one, two, mask).bias);
  FloatImage shown = constant(16, 16, 0.5f, 0.5f, 0.5f), other = constant(16, 16, 0.4f, 0.4f, 0.4f);
  shown.display_referred = other.display_referred = true;
  EXPECT_EQ(figures(shown, other, mask).flip.mean, figures(shown, other, mask, {.tone_map = ToneMap::none}).flip.mean);
}

TEST(Compare, SameBitsWithAnyNumberOfThreads) {
  const FloatImage a = linear_image(noise(90, 200, 1)), b = linear_image(noise(90, 200, 5000));
  const PictureError one = measured(a, b, everywhere(90, 200), {.threads = 1});
  const PictureError many = measured(a, b, everywhere(90, 200), {.threads = 7});
  EXPECT_EQ(one.flip, many.flip);
  EXPECT_EQ(one.figures->flip.mean, many.figures->flip.mean);
}

TEST(Mask, BandIsRoundAndEvenOnBothSides) {
  Mask mask = everywhere(41, 41);
  std::fill(mask.inside.begin(), mask.inside.end(), 0);
  mask.inside[20 * 41 + 20] = 1;
  const Mask band = silhouette_band(mask, 8);
  for (int y = 0; y < 41; ++y) {
    for (int x = 0; x < 41; ++x) {
      const bool near = std::hypot(x - 20, y - 20) <= 8;
      ASSERT_EQ(band.inside[static_cast<std::size_t>(y * 41 + x)], near ? 1 : 0) << x << " " << y;
    }
  }
  Mask half = everywhere(40, 10);
  for (std::size_t i = 0; i < half.inside.size(); ++i) half.inside[i] = i % 40 < 20;
  EXPECT_EQ(silhouette_band(half, 8).count(), 16u * 10) << "8 pixels to each side";
  EXPECT_EQ(silhouette_band(half, 0).count(), 0u);
  EXPECT_EQ(silhouette_band(half, 1000).count(), 400u);
  EXPECT_EQ(silhouette_band(everywhere(9, 9), 8).count(), 0u) << "the border is no edge";
}

TEST(Mask, FromAlphaLuminanceAndUnion) {
  FloatImage image = constant(4, 1, 0, 0, 0, 0);
  image.rgba = {1, 1, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1.0f / 255, 0, 0, 0, std::numeric_limits<float>::quiet_NaN()};
  EXPECT_EQ(alpha_mask(image).inside, (std::vector<std::uint8_t>{1, 1, 1, 0}));
  EXPECT_EQ(luminance_mask(image).inside, (std::vector<std::uint8_t>{1, 0, 0, 0}));
  const Mask a{2, 2, {0, 0, 1, 1}}, b{2, 2, {0, 1, 0, 1}};
  EXPECT_EQ(union_of(a, b).inside, (std::vector<std::uint8_t>{0, 1, 1, 1}));
  EXPECT_EQ(union_of(a, b).inside, union_of(b, a).inside);
}

TEST(ErrorMap, GetsLighterWithTheError) {
  const std::vector<float> errors = {0, 0.25f, 0.5f, 0.75f, 1};
  const Image map = error_picture(errors, 5, 1);
  int last = -1;
  for (std::size_t i = 0; i < map.rgba.size(); i += 4) {
    const int luma = 2126 * map.rgba[i] + 7152 * map.rgba[i + 1] + 722 * map.rgba[i + 2];
    EXPECT_GT(luma, last);
    EXPECT_EQ(map.rgba[i + 3], 255);
    last = luma;
  }
  const Image ends = error_picture({-1, std::numeric_limits<float>::quiet_NaN()}, 2, 1);
  EXPECT_TRUE(std::equal(ends.rgba.begin(), ends.rgba.begin() + 4, map.rgba.begin()));
  EXPECT_TRUE(std::equal(ends.rgba.begin() + 4, ends.rgba.end(), map.rgba.end() - 4));
}

}  // namespace
}  // namespace pelage
