// Finishing a picture gives the same bits on any number of threads.
#include "renderer/finish/finish.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace pelage::testing::finish_test {
namespace {

/// Random light and coverage, with empty pixels and even areas.
FloatImage some_light(int width, int height) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> share(0, 1);
  FloatImage light;
  light.width = width, light.height = height;
  for (int i = 0; i < width * height; ++i) {
    const float alpha = i % 7 == 0 ? 0.0f : i % 3 == 0 ? 1.0f : share(random);
    for (int k = 0; k < 3; ++k) light.rgba.push_back(alpha * std::exp2(8 * share(random) - 6));
    light.rgba.push_back(alpha);
  }
  std::fill(light.rgba.begin(), light.rgba.begin() + light.rgba.size() / 4, 0.0f);
  return light;
}

FurFrame frame_with(Background background, ToneMap tone_map) {
  FurFrame frame;
  frame.width = 101, frame.height = 67;
  frame.background = background, frame.tone_map = tone_map, frame.background_colour = {0.02f, 0.3f, 0.7f};
  frame.exposure = 0.6;
  return frame;
}

TEST(FinishedPicture, GivesTheSameBitsOnAnyNumberOfThreads) {
  const FurFrame frame = frame_with(Background::studio, ToneMap::filmic);
  const FloatImage light = some_light(50, 33);
  const Image one = finish_picture(frame, {light, nullptr, 1});
  for (const int threads : {2, 7})
    EXPECT_EQ(finish_picture(frame, {light, nullptr, threads}).rgba, one.rgba) << threads;
}

}  // namespace
}  // namespace pelage::testing::finish_test
