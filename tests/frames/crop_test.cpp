// A crop is drawn alone and has the same bits as that part of the whole frame.
#include <algorithm>

#include "renderer/image/cropped.h"
#include "server/frames/fur_view.h"
#include "tests/frames/groomed_frames.h"
#include "tests/frames/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage::testing::crop_test {
namespace {

constexpr int width = 150, height = 110;

FrameRequest frame_at(double scale) {
  FrameRequest request = small_frame(AutoView::three_quarter, width);
  request.height = height;
  request.knobs.scale = scale;
  return request;
}

/// Crops that begin where tiles of 16 pixels begin at half the size, that end at the picture's edge, and of one pixel.
std::vector<Crop> crops() { return {{32, 32, 64, 32}, {0, height - 9, width, 9}, {75, 55, 1, 1}}; }

FurredModel animal() {
  FurredModel model = coarse(furred({Builtin::creature, 2000}));
  model.settings.ground = {.visible = true, .height = {}, .shadow = 1, .contact = 1};
  model.settings.coats[0].coat.guard_hairs = 200;
  return model;
}

template <class Picture>
Picture crop_of(const Picture& whole, const Crop& crop) {
  return cropped(whole, crop.left, crop.top, crop.width, crop.height);
}

/// Draws the frame whole, and each crop with and without pauses; expects equal bits.
template <class Drawer>
void expect_crops_of_the_whole(Drawer& drawer, const FurFrame& frame) {
  constexpr std::array aovs{Aov::beauty, Aov::normal, Aov::depth};
  const Image picture = drawer.draw(frame).value();
  const Image16 deep = drawer.draw_deep(frame).value();
  const std::vector<FloatImage> aov_images = drawer.draw_aovs(frame, aovs).value();
  const Pause pause = [] { return true; };
  for (const Crop& crop : crops()) {
    FurFrame part = frame;
    part.crop = crop;
    SCOPED_TRACE(::testing::Message() << crop.left << " " << crop.top);
    const Image alone = drawer.draw(part).value();
    ASSERT_EQ(glm::ivec2(alone.width, alone.height), glm::ivec2(crop.width, crop.height));
    EXPECT_TRUE(alone.rgba == crop_of(picture, crop).rgba);
    EXPECT_TRUE(drawer.draw(part, nullptr, pause)->rgba == crop_of(picture, crop).rgba);
    EXPECT_TRUE(drawer.draw_deep(part)->rgba == crop_of(deep, crop).rgba);
    const std::vector<FloatImage> parts = drawer.draw_aovs(part, aovs).value();
    for (std::size_t i = 0; i < aovs.size(); ++i) EXPECT_TRUE(parts[i].rgba == crop_of(aov_images[i], crop).rgba) << i;
  }
}

class Crops : public WithRenderer {
 protected:
  FurFrame frame_of(const FurredModel& model, const FrameRequest& request) {
    sync_scene(*renderer, model.view(), {});
    return make_frame(model.view(), request);
  }
};

TEST_F(Crops, HaveTheBitsOfTheWhole) {
  const FurredModel model = animal();
  for (const double scale : {0.5, 1.0, 1.7}) {
    FrameRequest request = frame_at(scale);
    SCOPED_TRACE(scale);
    expect_crops_of_the_whole(*renderer, frame_of(model, request));
  }
}

TEST_F(Crops, OverlaysLieWhereTheyLieOnTheWhole) {
  const FurredModel model = animal();
  for (const Overlay overlay : {Overlay::direction, Overlay::wire}) {
    FrameRequest request = frame_at(1);
    request.overlay = overlay, request.background = Background::studio;
    FurFrame frame = frame_of(model, request);
    const Image whole = renderer->draw(frame).value();
    frame.crop = {40, 30, 37, 41};
    EXPECT_TRUE(renderer->draw(frame)->rgba == crop_of(whole, *frame.crop).rgba) << static_cast<int>(overlay);
  }
}

class CropsAfterStrokes : public GroomedFrames {
  Drawn draw_after(const FurredModel&, const std::vector<DirtyRange>&) override { return {}; }
  void forget_views() override {}
};

TEST_F(CropsAfterStrokes, HaveTheBitsOfTheWhole) {
  FurredModel model = coarse(furred({Builtin::creature, 2000}));
  Renderer renderer(RendererOptions{.threads = 2}), fresh(RendererOptions{.threads = 2});
  FrameRequest asked = frame_at(1);
  asked.crop = {40, 30, 37, 41};
  sync_scene(renderer, model.view(), {});
  ASSERT_TRUE(renderer.draw(make_frame(model.view(), asked)).ok());
  for (int k = 0; k < 4; ++k) {
    std::vector<VertexRange> ranges;
    for (const DirtyRange& range : stroke(model)) ranges.push_back({range.begin, range.end});
    sync_scene(renderer, model.view(), ranges);
    FurFrame frame = make_frame(model.view(), asked);
    const Image again = renderer.draw(frame).value();
    sync_scene(fresh, model.view(), ranges);
    frame.crop.reset();
    EXPECT_TRUE(again.rgba == crop_of(fresh.draw(frame).value(), *asked.crop).rgba) << k;
  }
}

}  // namespace
}  // namespace pelage::testing::crop_test
