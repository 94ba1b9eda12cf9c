// Pictures finished without a GL beside those of the resolve pass.
#include "renderer/finish/finish.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "renderer/gl/handles.h"
#include "renderer/passes/resolve/resolve_pass.h"
#include "tests/gl/backends.h"

namespace pelage::testing::finish_test {
namespace {

/// Light of any strength and cover, some of it empty and some of it even.
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

template <class Picture>
int furthest_apart(const Picture& a, const Picture& b) {
  int most = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) most = std::max(most, std::abs(int{a.rgba[i]} - int{b.rgba[i]}));
  return a.rgba.size() == b.rgba.size() ? most : 1 << 16;
}

class FinishedLight : public OnBackend {
 protected:
  template <class Picture>
  Picture resolved(const FurFrame& frame, const FloatImage& light, GLenum format, GLenum type, int largest) {
    ResolvePass pass(gl());
    const RenderTarget drawn(gl(), GL_RGBA32F, light.width, light.height, false);
    const RenderTarget target(gl(), format, frame.width, frame.height, false);
    gl().TextureSubImage2D(drawn.texture(), 0, 0, 0, light.width, light.height, GL_RGBA, GL_FLOAT, light.rgba.data());
    gl().ClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    pass.draw(gl(), frame, drawn, target, largest, 0);
    Picture picture{frame.width, frame.height, {}};
    picture.rgba.resize(4 * static_cast<std::size_t>(frame.width * frame.height));
    gl().PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl().ReadPixels(0, 0, frame.width, frame.height, GL_RGBA, type, picture.rgba.data());
    return picture;
  }

  void expect_alike(const FurFrame& frame, const FloatImage& light) {
    const Image small = resolved<Image>(frame, light, GL_RGBA8, GL_UNSIGNED_BYTE, 255);
    EXPECT_LE(furthest_apart(finish_picture(frame, {light}), small), 1);
    const Image16 deep = resolved<Image16>(frame, light, GL_RGBA16, GL_UNSIGNED_SHORT, 65535);
    EXPECT_LE(furthest_apart(finish_picture_deep(frame, {light}), deep), 2);
  }
};

TEST_P(FinishedLight, EveryBackgroundAndToneMapIsThatOfTheShader) {
  for (const Background background : {Background::colour, Background::transparent, Background::studio}) {
    for (const ToneMap tone_map : {ToneMap::none, ToneMap::filmic}) {
      SCOPED_TRACE(::testing::Message() << static_cast<int>(background) << " " << static_cast<int>(tone_map));
      const FurFrame frame = frame_with(background, tone_map);
      expect_alike(frame, some_light(frame.width, frame.height));
    }
  }
}

TEST_P(FinishedLight, LightOfAnotherSizeIsEnlargedOrAveraged) {
  const FurFrame frame = frame_with(Background::studio, ToneMap::filmic);
  for (const double scale : {0.25, 0.5, 0.71, 1.3, 2.0}) {
    SCOPED_TRACE(scale);
    expect_alike(frame, some_light(std::lround(frame.width * scale), std::lround(frame.height * scale)));
  }
}

INSTANTIATE_TEST_SUITE_P(Backends, FinishedLight, ::testing::Values(Backend::egl_device), name_of);

TEST(FinishedPicture, GivesTheSameBitsOnAnyNumberOfThreads) {
  const FurFrame frame = frame_with(Background::studio, ToneMap::filmic);
  const FloatImage light = some_light(50, 33);
  const Image one = finish_picture(frame, {light, nullptr, 1});
  for (const int threads : {2, 7})
    EXPECT_EQ(finish_picture(frame, {light, nullptr, threads}).rgba, one.rgba) << threads;
}

}  // namespace
}  // namespace pelage::testing::finish_test
