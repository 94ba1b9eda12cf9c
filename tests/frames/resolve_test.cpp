// From linear light to the picture: exposure, tone map, background and sRGB, against their formulas.
#include <algorithm>
#include <cmath>

#include "base/colour_space.h"
#include "server/frames/fur_view.h"
#include "tests/frames/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage::testing::resolve_test {
namespace {

class Resolve : public WithRenderer {
 protected:
  Image16 picture(const FrameRequest& request) {
    sync_scene(*renderer, model.view(), {{0, static_cast<std::uint32_t>(model.fields.size())}});
    return renderer->draw_deep(make_frame(model.view(), request)).value();
  }
  FurredModel model = furred({Builtin::sphere, 500}, {.length = 0.04});
};

double linear(std::uint16_t srgb) { return linear_from_srgb(srgb / 65535.0); }

double filmic(double x) {
  x *= 0.72;
  return std::clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}

/// Calls `visit` with the index and the opacity of each colour channel, for pixels with some opacity. Returns their
/// number.
template <class Visit>
int for_each_channel(const Image16& image, Visit visit) {
  int seen = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    if (image.rgba[i + 3] < 6000) continue;  // colours of faint pixels have few digits
    for (std::size_t k = 0; k < 3; ++k) visit(i + k, image.rgba[i + 3] / 65535.0);
    ++seen;
  }
  return seen;
}

TEST_F(Resolve, AStopOfExposureDoublesTheLight) {
  FrameRequest request = small_frame();
  request.exposure = -2;
  const Image16 dark = picture(request);
  for (const double stops : {-3.0, -1.0, 0.5}) {
    request.exposure = stops;
    const Image16 other = picture(request);
    const int seen = for_each_channel(dark, [&](std::size_t i, double) {
      const double expected = std::min(linear(dark.rgba[i]) * std::exp2(stops + 2), 1.0);
      ASSERT_NEAR(linear(other.rgba[i]), expected, 2e-4 + 1e-3 * expected) << stops;
    });
    EXPECT_GT(seen, 3000);
  }
}

TEST_F(Resolve, TheFilmicCurveIsItsFormula) {
  FrameRequest request = small_frame();
  request.exposure = -1;
  const Image16 plain = picture(request);
  request.tone_map = ToneMap::filmic;
  const Image16 film = picture(request);
  for_each_channel(plain, [&](std::size_t i, double) {
    if (plain.rgba[i] == 65535) return;  // clipped, as brighter than white
    ASSERT_NEAR(linear(film.rgba[i]), filmic(linear(plain.rgba[i])), 3e-4);
  });
  EXPECT_NEAR(filmic(0.18), 0.18, 0.005);
}

TEST_F(Resolve, TheBackgroundShowsInLinearLight) {
  FrameRequest request = small_frame();
  const Image16 fur = picture(request);
  request.background = Background::colour;
  request.background_colour = {0.1f, 0.5f, 0.9f};
  const Image16 over = picture(request);
  int partial = 0;
  for_each_channel(fur, [&](std::size_t i, double alpha) {
    const double behind = double(request.background_colour[static_cast<int>(i % 4)]);
    partial += alpha < 0.9;
    ASSERT_NEAR(linear(over.rgba[i]), linear(fur.rgba[i]) * alpha + behind * (1 - alpha), 5e-4);
  });
  EXPECT_GT(partial, 100);
  EXPECT_NEAR(linear(over.rgba[1]), 0.5, 1e-4);
  EXPECT_EQ(over.rgba[3], 65535);
}

/// Premultiplied linear light of a pixel; coordinates outside are clamped.
double light_at(const Image16& image, int x, int y, std::size_t channel) {
  x = std::clamp(x, 0, image.width - 1), y = std::clamp(y, 0, image.height - 1);
  const std::size_t i =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  const double alpha = image.rgba[i + 3] / 65535.0;
  return channel == 3 ? alpha : linear(image.rgba[i + channel]) * alpha;
}

double catmull_rom(double x) {
  x = std::abs(x);
  return x < 1 ? 1 + x * x * (1.5 * x - 2.5) : x < 2 ? 2 + x * (-4 + x * (2.5 - 0.5 * x)) : 0;
}

/// Catmull-Rom interpolation of drawn pixels without the corner taps, clamped to the range of the four nearest pixels.
double enlarged(const Image16& drawn, double x, double y, std::size_t channel) {
  const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
  double sum = 0, weights = 0, low = 1e9, high = -1e9;
  for (int row = top - 1; row <= top + 2; ++row) {
    for (int column = left - 1; column <= left + 2; ++column) {
      const double light = light_at(drawn, column, row, channel);
      const bool near_x = column == left || column == left + 1, near_y = row == top || row == top + 1;
      if (!near_x && !near_y) continue;
      const double weight = catmull_rom(x - column) * catmull_rom(y - row);
      sum += weight * light, weights += weight;
      if (near_x && near_y) low = std::min(low, light), high = std::max(high, light);
    }
  }
  return std::clamp(sum / weights, low, high);
}

TEST_F(Resolve, PartSizeFramesAreEnlargedByCatmullRom) {
  FrameRequest request = small_frame();
  request.exposure = -4;  // nothing is brighter than white
  // The camera sees strands at the silhouette from so near that both frames read the finest texels: the light is the
  // same.
  request.camera = {
      .automatic = AutoView::none, .position = {1.07, 0, 1.4}, .target = {1.07, 0, 0}, .fov_degrees = 1.5};
  const double scale = 0.5;
  request.knobs.scale = scale;
  const Image16 picture_of_part = picture(request);
  request.knobs.scale = 1, request.width = request.height = 64;
  const Image16 drawn = picture(request);
  double largest = 0, sum = 0, sum_to_nearest = 0;
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) {
      for (std::size_t channel = 0; channel < 4; ++channel) {
        const double expected = enlarged(drawn, (x + 0.5) * scale - 0.5, (y + 0.5) * scale - 0.5, channel);
        const double shown = light_at(picture_of_part, x, y, channel);
        largest = std::max(largest, std::abs(shown - expected));
        sum += std::abs(shown - expected), sum_to_nearest += std::abs(shown - light_at(drawn, x / 2, y / 2, channel));
      }
    }
  }
  EXPECT_LT(largest, 1e-2);  // colours of faint pixels have few digits
  EXPECT_LT(sum, 3e-3 * sum_to_nearest);
}

}  // namespace
}  // namespace pelage::testing::resolve_test
