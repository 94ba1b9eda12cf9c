// The bytes in which the worker and the journal hand on pictures of maps.
#include "server/import/map_picture.h"

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <tuple>

#include "base/limits.h"

namespace pelage {
namespace {

MapPicture grey(int width, int height, int bits) {
  MapPicture picture{width, height, bits, 0.25, {}};
  for (int pixel = 0; pixel < width * height; ++pixel) {
    const float value = static_cast<float>(pixel % 256) / 255.0f;
    picture.rgba.insert(picture.rgba.end(), {value, value, value, 1});
  }
  return picture;
}

Result<MapPicture> decoded(const MapPicture& picture) {
  const std::string bytes = encode_map_picture(picture);
  return decode_map_picture(std::as_bytes(std::span(bytes)));
}

TEST(MapPicture, ComesBackAsItWas) {
  for (const int bits : {8, 16, 32}) {
    const MapPicture picture = grey(7, 5, bits);
    const auto back = decoded(picture);
    ASSERT_TRUE(back.ok()) << bits;
    EXPECT_EQ(std::make_tuple(back->width, back->height, back->bits, back->scale), std::make_tuple(7, 5, bits, 0.25));
    for (std::size_t i = 0; i < picture.rgba.size(); ++i) EXPECT_NEAR(back->rgba[i], picture.rgba[i], 1e-6) << bits;
  }
}

TEST(MapPicture, ListHasMoreRowsThanAPicture) {
  const auto back = decoded(grey(1, 3 * limits::picture_pixels, 32));
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(back->height, 3 * limits::picture_pixels);
  EXPECT_FALSE(decoded(grey(2, limits::picture_pixels + 1, 8)).ok());
  EXPECT_FALSE(decoded(grey(limits::picture_pixels + 1, 1, 8)).ok());
}

}  // namespace
}  // namespace pelage
