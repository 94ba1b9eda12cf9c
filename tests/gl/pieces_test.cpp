// A long frame is drawn in pieces, with the bits of a whole one, and others may be drawn in between.
#include "renderer/frame/pieces.h"

#include <algorithm>

#include "server/frames/fur_view.h"
#include "tests/gl/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage::testing::pieces_test {
namespace {

class FramesInPieces : public WithRenderer {
 protected:
  FurFrame frame_of(const FurredModel& model, const FrameRequest& request) {
    sync_scene(*renderer, model.view(), {});
    return make_frame(model.view(), request);
  }
  std::vector<std::uint8_t> whole(const FurFrame& frame) { return renderer->draw(frame).value().rgba; }
};

FrameRequest large(Tier tier, int pixels) {
  FrameRequest request = small_frame(AutoView::three_quarter, pixels);
  request.knobs = knobs_of(tier);
  request.knobs.scale = 1;
  return request;
}

FurredModel lit(const Light& light) {
  FurredModel model = furred({Builtin::creature, 2000});
  model.settings.lights = {light};
  model.settings.look.shading = ShadingModel::kajiya;  // the pieces are the same for each, and this is the fastest
  model.settings.ground.visible = true;
  return model;
}

TEST_P(FramesInPieces, HaveTheBitsOfAWholeOne) {
  const FurredModel model = lit({.self_shadow_maps = true, .cast_shadow = CastShadow::soft});
  FurredModel other = furred({Builtin::sphere, 300});
  const FurFrame between = frame_of(other, small_frame());
  FrameRequest layers = large(Tier::interactive, 256);
  layers.knobs.shells = 128;
  FrameRequest hairy = layers;
  hairy.knobs.guard_hairs = 200, hairy.knobs.shadow_maps = true;
  FrameRequest shown = layers;
  shown.overlay = Overlay::shell_count;
  for (const FrameRequest& request : {layers, hairy, shown, large(Tier::detailed, 400)}) {
    const FurFrame frame = frame_of(model, request);
    const std::vector<std::uint8_t> expected = whole(frame);
    int pauses = 0;
    const Result<Image> image = renderer->draw(frame, nullptr, [&] {
      // Another picture leaves targets, maps and tables of its own.
      if (++pauses == 2) {
        EXPECT_TRUE(renderer->draw(between).ok());
      }
      return true;
    });
    ASSERT_TRUE(image.ok()) << image.status().message;
    EXPECT_GT(pauses, 2);
    EXPECT_TRUE(image->rgba == expected);
  }
}

TEST_P(FramesInPieces, LayersBesideLightToo) {
  const FurredModel model = lit({});
  const FurFrame frame = frame_of(model, large(Tier::detailed, 400));
  const std::array asked{Aov::beauty, Aov::normal};
  const auto expected = renderer->draw_aovs(frame, asked).value();
  int pauses = 0;
  const auto images = renderer->draw_aovs(frame, asked, nullptr, [&] { return ++pauses > 0; }).value();
  EXPECT_GT(pauses, 2);
  for (std::size_t i = 0; i < asked.size(); ++i) EXPECT_TRUE(images[i].rgba == expected[i].rgba) << i;
}

TEST_P(FramesInPieces, CanBeGivenUpHalfWay) {
  const FurredModel model = lit({});
  const FurFrame frame = frame_of(model, large(Tier::detailed, 400));
  const std::vector<std::uint8_t> expected = whole(frame);
  int pauses = 0;
  EXPECT_EQ(renderer->draw(frame, nullptr, [&] { return ++pauses < 3; }).status().code, Code::conflict);
  EXPECT_EQ(pauses, 3);
  EXPECT_TRUE(renderer->draw(frame).value().rgba == expected);  // nothing of the half is taken for a picture
}

TEST_P(FramesInPieces, ASmallFrameIsOne) {
  const FurredModel model = lit({});
  const FurFrame frame = frame_of(model, small_frame());
  const std::vector<std::uint8_t> expected = whole(frame);  // which bakes the coat
  int pauses = 0;
  EXPECT_TRUE(renderer->draw(frame, nullptr, [&] { return ++pauses > 0; }).value().rgba == expected);
  EXPECT_EQ(pauses, 0);
}

TEST_P(FramesInPieces, OthersAreDrawnWhileACoatIsBaked) {
  FurredModel model = lit({});
  const FurFrame between = frame_of(model, small_frame());
  ASSERT_TRUE(renderer->draw(between).ok());
  model.settings.coat.seed = 977;  // which nobody has baked
  const FurFrame frame = make_frame(model.view(), small_frame());
  int pauses = 0;
  const auto give_up = [&] { return ++pauses < 1; };
  EXPECT_EQ(renderer->draw(frame, nullptr, give_up).status().code, Code::conflict);
  EXPECT_EQ(pauses, 1);
  const Result<Image> image =
      renderer->draw(frame, nullptr, [&] { return ++pauses > 2 || renderer->draw(between).ok(); });
  ASSERT_TRUE(image.ok()) << image.status().message;
  EXPECT_GT(pauses, 1);
  EXPECT_TRUE(image->rgba == whole(frame));
}

/// So much work in each pixel left of `edge`, and none beside it.
Pieces::Work fur_left_of(int edge, double of_pixel) {
  return
      [=](const Area& in) { return of_pixel * std::max(0, std::min(edge, in.left + in.width) - in.left) * in.height; };
}

TEST(Pieces, AreCutWhereTheFurIs) {
  Pieces pieces({0, 0, 1024, 1024}, fur_left_of(512, 16), 1e-3);
  double pixels = 0, largest_furred = 0, largest_empty = 0;
  while (!pieces.done()) {
    const Area piece = pieces.next();
    pixels += piece.pixels();
    double& largest = piece.left < 512 ? largest_furred : largest_empty;
    largest = std::max(largest, piece.pixels());
    pieces.took(16e-3 * piece.pixels());  // as expected
  }
  EXPECT_EQ(pixels, 1024 * 1024);
  EXPECT_EQ(largest_empty, 512 * 1024);
  EXPECT_LE(16e-3 * largest_furred, Pieces::target_ms);
  EXPECT_GE(16e-3 * largest_furred, Pieces::target_ms / 4);
}

TEST(Pieces, ShrinkWhereFurIsSlowAndGrowWhereItIsQuick) {
  Pieces pieces({0, 0, 1024, 1024}, fur_left_of(1024, 16), 1e-3);
  const double first = pieces.next().pixels();
  pieces.took(4 * Pieces::target_ms);
  const double slow = pieces.next().pixels();
  EXPECT_LE(slow, first / 4);
  double quick = slow;
  while (quick <= slow && !pieces.done()) {
    pieces.took(Pieces::target_ms / 100);
    quick = pieces.next().pixels();
  }
  EXPECT_GT(quick, slow);
}

TEST(Pieces, AreNeverSmallerThanTheirTrianglesAreWorth) {
  Pieces pieces({0, 0, 256, 256}, fur_left_of(256, 1e9), 1e-3);
  while (!pieces.done()) {
    EXPECT_EQ(pieces.next().pixels(), Pieces::min_pixels);
    pieces.took(1e6);
  }
}

INSTANTIATE_TEST_SUITE_P(Gl, FramesInPieces, both_backends(), name_of);

}  // namespace
}  // namespace pelage::testing::pieces_test
