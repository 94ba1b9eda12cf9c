#include "server/http/accept_format.h"

#include <gtest/gtest.h>

namespace pelage {
namespace {

constexpr auto png = FrameFormat::png, jpeg = FrameFormat::jpeg, webp = FrameFormat::webp;

TEST(AcceptFormat, ChoosesTheNamedFormatOfTheHighestWeight) {
  EXPECT_EQ(accepted_format("image/jpeg"), jpeg);
  EXPECT_EQ(accepted_format("image/webp, image/jpeg;q=0.5"), webp);
  EXPECT_EQ(accepted_format("image/webp;q=0.5, image/jpeg"), jpeg);
  EXPECT_EQ(accepted_format("IMAGE/WebP , */*;q=0.1"), webp);
  EXPECT_EQ(accepted_format("image/png;q=0.2, image/webp;q=0.3"), webp);
}

TEST(AcceptFormat, OfEqualsPngThenJpeg) {
  EXPECT_EQ(accepted_format("image/webp, image/jpeg, image/png"), png);
  EXPECT_EQ(accepted_format("image/webp, image/jpeg"), jpeg);
}

TEST(AcceptFormat, NamingNoneGivesPng) {
  for (const char* text : {"", "*/*", "image/*", "text/html", "image/avif", "image/webp;q=0", "image/jpeg;q=2"})
    EXPECT_EQ(accepted_format(text), png) << text;
}

}  // namespace
}  // namespace pelage
