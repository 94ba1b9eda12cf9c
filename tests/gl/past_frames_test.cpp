// Frames of earlier revisions through the frame service, on a context of its own.
#include "server/frames/frame_service.h"
#include "server/frames/shown_scene.h"
#include "tests/gl/backends.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage::testing::past_frames_test {
namespace {

class PastFrames : public StoreTest, public ::testing::WithParamInterface<Backend> {
 protected:
  void SetUp() override {
    StoreTest::SetUp();
    auto started = FrameService::start(GetParam() == Backend::osmesa ? GlChoice::osmesa : GlChoice::egl, 2, gate_);
    if (started) {
      frames_ = std::move(*started);
      return;
    }
    if (in_ci()) FAIL() << started.status().message;
    GTEST_SKIP() << started.status().message;
  }
  void TearDown() override {
    frames_.reset();
    StoreTest::TearDown();
  }

  FrameAnswer draw(const std::shared_ptr<Scene>& scene, std::optional<Revision> revision = {}) const {
    FrameRequest request;
    request.width = request.height = 96, request.knobs = knobs_of(Tier::draft), request.revision = revision;
    Result<FrameAnswer> answer = frames_->frame(scene, request);
    EXPECT_TRUE(answer.ok()) << answer.status().message << answer.status().pointer;
    return answer.ok() ? std::move(*answer) : FrameAnswer{};
  }
  static SetCoat blue_coat() {
    SetCoat set;
    set.coat.ramp = {{0, {0, 0, 1}}, {1, {0, 0, 1}}};
    return set;
  }
  /// What was drawn at each revision: strokes, an undo and another coat.
  std::vector<std::string> groom(const std::shared_ptr<Scene>& scene) const {
    std::vector<std::string> seen{draw(scene).bytes};
    const auto see = [&](const CommandAnswer& answer) {
      EXPECT_EQ(answer.revision, seen.size());
      seen.push_back(draw(scene).bytes);
    };
    see(execute(*scene, {comb_at(*scene, 5)}));
    see(execute(*scene, {comb_at(*scene, 200)}));
    see(move(*scene, Undo{2}));
    see(execute(*scene, {blue_coat()}));
    see(execute(*scene, {comb_at(*scene, 300)}));
    return seen;
  }

  YieldGate gate_;
  std::unique_ptr<FrameService> frames_;
};

TEST_P(PastFrames, AreWhatWasDrawnThen) {
  const auto scene = make();
  const std::vector<std::string> seen = groom(scene);
  EXPECT_NE(seen[4], seen[3]);
  for (const Revision revision : {0, 5, 1, 2, 3, 4, 4, 0, 2}) {
    const FrameAnswer past = draw(scene, revision);
    EXPECT_EQ(past.revision, revision);
    EXPECT_TRUE(past.bytes == seen[revision]) << revision;
    EXPECT_TRUE(draw(scene).bytes == seen.back()) << "the present after " << revision;
  }
}

TEST_P(PastFrames, SendNothingTwiceAndLeaveThePresentWhereItIs) {
  const auto scene = make();
  groom(scene);
  const std::size_t present = draw(scene).counters.bytes, first = draw(scene, 1).counters.bytes;
  const std::size_t model = 20 * scene->summary().report.vertices;  // bytes: less than what a model takes
  EXPECT_GT(first, present + model);
  EXPECT_EQ(draw(scene).counters.bytes, present);
  EXPECT_LT(draw(scene, 1).counters.bytes, present + model);
  draw(scene, 2);
  EXPECT_LT(draw(scene, 1).counters.bytes, present + model) << "two are kept";
  const auto control = make();  // of which only the present is drawn
  groom(control);
  const auto sent_by_stroke = [&](const std::shared_ptr<Scene>& of) {
    execute(*of, {comb_at(*of, 400)});
    return draw(of).counters.bytes;
  };
  EXPECT_EQ(sent_by_stroke(scene), sent_by_stroke(control));
}

TEST_P(PastFrames, CountAsTheirScenesAndGoWithItsModel) {
  const auto scene = make();
  draw(scene);
  const std::uint64_t id = scene->memory().copy_id;
  const std::size_t alone = frames_->copy_bytes(id);
  groom(scene);
  const std::size_t gl = frames_->gl_bytes();
  draw(scene, 1);
  const std::size_t one_copy = frames_->gl_bytes() - gl;
  EXPECT_GT(frames_->copy_bytes(id), 2 * alone) << "buffers as large, and fields";
  draw(scene, 2), draw(scene, 0), draw(scene);
  EXPECT_LT(frames_->copy_bytes(id), 5 * alone) << "two of three are kept";
  const std::size_t held = frames_->gl_bytes();
  ASSERT_TRUE(store_->subdivide(*scene, {}).ok());
  frames_->forget(id);
  FrameRequest request;
  request.revision = 1;
  EXPECT_EQ(frames_->frame(scene, request).status().pointer, "/revision");
  draw(make(Builtin::plane, 2));  // after the render thread has forgotten
  EXPECT_EQ(frames_->copy_bytes(id), 0u);
  EXPECT_LT(frames_->gl_bytes() + 2 * one_copy, held) << "more than its own copy went";
}

TEST_P(PastFrames, ASceneThatGoesOnMeanwhileIsShownAsItWasAskedFor) {
  ASSERT_TRUE(stage.context(GetParam()).ok());
  const Result<Renderer*> renderer = stage.renderer(GetParam());
  ASSERT_TRUE(renderer.ok());
  const auto scene = make();
  FrameRequest request;
  request.revision = 0;
  PastScenes scenes;
  Result<FramePast> past = past_of(*scene, request, scenes);
  ASSERT_TRUE(past.ok());
  EXPECT_FALSE(past->copy) << "of the present as long as it is asked for";
  execute(*scene, {comb_at(*scene, 5)});
  MovedFur fur;
  const Result<Shown> shown = show(**renderer, *scene, request, *past, scenes, fur, false, false);
  ASSERT_TRUE(shown.ok());
  EXPECT_EQ(shown->revision, 0u);
  ASSERT_TRUE(past->copy);
  EXPECT_EQ(shown->copy_id, past->copy->view().copy_id);
  for (const std::uint64_t id : {shown->copy_id, scene->memory().copy_id}) (*renderer)->forget(id);
}

INSTANTIATE_TEST_SUITE_P(Gl, PastFrames, both_backends(), name_of);

}  // namespace
}  // namespace pelage::testing::past_frames_test
