// Frames of earlier revisions through the frame service.
#include "server/frames/frame_service.h"
#include "server/frames/shown_scene.h"
#include "tests/frames/drawn.h"
#include "tests/support/furred_model.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage::testing::past_frames_test {
namespace {

class PastFrames : public StoreTest {
 protected:
  void SetUp() override {
    StoreTest::SetUp();
    frames_ = std::move(FrameService::start(without_gl, 2, gate_)).value();
  }
  void TearDown() override {
    frames_.reset();
    StoreTest::TearDown();
  }

  FrameAnswer draw(const std::shared_ptr<Scene>& scene, std::optional<Revision> revision = {}) const {
    FrameRequest request;
    request.width = request.height = 96, request.knobs = knobs_of(Tier::draft), request.revision = revision;
    Result<FrameAnswer> answer = drawn_frame(*frames_, scene, request);
    EXPECT_TRUE(answer.ok()) << answer.status().message << answer.status().pointer;
    return answer.ok() ? std::move(*answer) : FrameAnswer{};
  }
  static SetCoat coat_of(const std::vector<RampStop>& ramp) {
    SetCoat set;
    set.coat = coarse(set.coat), set.coat.ramp = ramp;
    return set;
  }
  /// A scene with few strands, at revision 1.
  std::shared_ptr<Scene> coarse_scene() const {
    auto scene = make();
    execute(*scene, {coat_of({{0, {1, 0, 0}}})});
    return scene;
  }
  /// Grooms a coarse scene with strokes, an undo and another coat. Returns the encoded frame of each revision but the
  /// first.
  std::vector<std::string> groom(const std::shared_ptr<Scene>& scene) const {
    std::vector<std::string> seen{"", draw(scene).bytes};
    const auto see = [&](const CommandAnswer& answer) {
      EXPECT_EQ(answer.revision, seen.size());
      seen.push_back(draw(scene).bytes);
    };
    see(execute(*scene, {comb_at(*scene, 5)}));
    see(execute(*scene, {comb_at(*scene, 200)}));
    see(move(*scene, Undo{2}));
    see(execute(*scene, {coat_of({{0, {0, 0, 1}}})}));
    see(execute(*scene, {comb_at(*scene, 300)}));
    return seen;
  }

  YieldGate gate_;
  std::unique_ptr<FrameService> frames_;
};

TEST_F(PastFrames, AreWhatWasDrawnThen) {
  const auto scene = coarse_scene();
  const std::vector<std::string> seen = groom(scene);
  EXPECT_NE(seen[5], seen[4]);
  for (const Revision revision : {1, 6, 2, 3, 4, 5, 5, 1, 3}) {
    const FrameAnswer past = draw(scene, revision);
    EXPECT_EQ(past.revision, revision);
    EXPECT_TRUE(past.bytes == seen[revision]) << revision;
    EXPECT_TRUE(draw(scene).bytes == seen.back()) << "the present after " << revision;
  }
}

TEST_F(PastFrames, CountAsTheirScenesAndGoWithItsModel) {
  const auto scene = coarse_scene();
  draw(scene);
  const std::uint64_t id = scene->memory().copy_id;
  const std::size_t alone = frames_->copy_bytes(id);
  groom(scene);
  draw(scene, 2);
  EXPECT_GT(frames_->copy_bytes(id), 2 * alone) << "strands as many, and fields";
  draw(scene, 3), draw(scene, 1), draw(scene);
  EXPECT_LT(frames_->copy_bytes(id), 5 * alone) << "two of three are kept";
  ASSERT_TRUE(store_->subdivide(*scene, {}).ok());
  frames_->forget(id);
  FrameRequest request;
  request.revision = 1;
  EXPECT_EQ(drawn_frame(*frames_, scene, request).status().pointer, "/revision");
  draw(make(Builtin::plane, 2));  // the render thread forgets before it draws this
  EXPECT_EQ(frames_->copy_bytes(id), 0u);
}

TEST_F(PastFrames, ASceneThatGoesOnMeanwhileIsShownAsItWasAskedFor) {
  Renderer renderer{{.threads = 2}};
  const auto scene = coarse_scene();
  FrameRequest request = small_frame();
  request.revision = 1;
  PastScenes scenes;
  const Result<FrameView> view = view_of(*scene, request, scenes);
  ASSERT_TRUE(view.ok());
  EXPECT_EQ(view->snapshot, scene->snapshot()) << "the present as long as it is asked for";
  const FieldsHash asked = hash(*scene);
  execute(*scene, {comb_at(*scene, 5)});
  RendererCopyStates fur;
  const ShownScene newest = sync_snapshot(renderer, fur, scene->snapshot(), request);
  const ShownScene shown = sync_snapshot(renderer, fur, view->snapshot, request);
  EXPECT_EQ(newest.revision(), 2u);
  EXPECT_EQ(shown.revision(), 1u);
  EXPECT_EQ(shown.snapshot->fields->hash(), asked);
  Renderer other{{.threads = 2}};
  RendererCopyStates none;
  EXPECT_EQ(renderer.draw(shown.fur)->rgba, other.draw(sync_snapshot(other, none, view->snapshot, request).fur)->rgba)
      << "what a newer snapshot has changed is taken back";
}

}  // namespace
}  // namespace pelage::testing::past_frames_test
