// Parts of a view, drawn as the truth, tell how far knobs are from it in all of the view.
#include <atomic>
#include <thread>

#include "renderer/frame/run_beside.h"
#include "renderer/quality/view_features.h"
#include "server/frames/error_probe.h"
#include "server/frames/frame_queue.h"
#include "server/frames/fur_view.h"
#include "tests/gl/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage::testing {
namespace {

class Probe : public WithRenderer {};

TEST_P(Probe, TellsHowFarTheWholeIsFromTheTruth) {
  FurredModel model = furred({Builtin::creature, 3000}, {.length = 0.03});
  FrameRequest request = small_frame(AutoView::three_quarter, 224);
  request.background = Background::transparent;
  sync_scene(*renderer, model.view(), {});
  const FurFrame frame = make_frame(model.view(), request);
  const ViewFeatures view = view_features(frame, furred_skin(model.view()));
  ASSERT_EQ(view.places.size(), 6u);
  const auto whole = [&](const Knobs& knobs) {
    FurFrame drawn = frame;
    drawn.knobs = knobs;
    return renderer->draw(drawn).value();
  };
  const Image truth = whole(reference_knobs(128));
  ErrorProbe probe(*renderer, frame, view.places, 128);
  double before = 1;
  for (const int shells : {4, 8, 16}) {
    Knobs knobs = knobs_of(Tier::interactive);
    knobs.shells = shells;
    const double error = fur_error(truth, whole(knobs))->mean, told = probe.error(knobs).value();
    EXPECT_NEAR(told, error, 0.05 * error) << shells;  // off by .8 to 2 % when this was written
    EXPECT_LT(told, before);
    before = told;
  }
  EXPECT_LT(probe.error(reference_knobs(128)).value(), 1e-4);
}

TEST_P(Probe, OthersAreServedWhilePicturesAreCompared) {
  FurredModel model = furred({Builtin::sphere, 300}, {.length = 0.03});
  sync_scene(*renderer, model.view(), {});
  const FurFrame frame = make_frame(model.view(), small_frame(AutoView::three_quarter, 512));
  const ViewFeatures view = view_features(frame, furred_skin(model.view()));
  Knobs knobs = knobs_of(Tier::draft);
  knobs.shells = 8;
  const double expected = ErrorProbe(*renderer, frame, view.places, 32).error(knobs).value();
  int pauses = 0;
  ErrorProbe paused(*renderer, frame, view.places, 32, [&] { return ++pauses > 0; });
  EXPECT_EQ(paused.error(knobs), expected);
  EXPECT_GT(pauses, 0);
  ErrorProbe given_up(*renderer, frame, view.places, 32, [] { return false; });
  EXPECT_FALSE(given_up.error(knobs));
}

TEST(RunBeside, AsksUntilTheWorkIsDone) {
  int pauses = 0;
  std::atomic<bool> enough = false;
  const auto done = run_beside([&] { return enough = ++pauses >= 3, true; },
                               [&](const auto& go_on) {
                                 while (!enough && go_on()) std::this_thread::yield();
                                 return 7;
                               });
  EXPECT_EQ(done, 7);
  EXPECT_GE(pauses, 3);
}

TEST(RunBeside, EndsTheWorkOnceThePauseGivesUp) {
  const auto done = run_beside([] { return false; },
                               [](const auto& go_on) {
                                 while (go_on()) std::this_thread::yield();
                                 return 7;
                               });
  EXPECT_FALSE(done);
}

TEST_P(Probe, NothingSeenTellsNothing) {
  FurredModel model = furred({Builtin::sphere, 300});
  sync_scene(*renderer, model.view(), {});
  const FurFrame frame = make_frame(model.view(), small_frame(AutoView::front, 64));
  EXPECT_FALSE(ErrorProbe(*renderer, frame, {}, 128).error(knobs_of(Tier::draft)));
}

INSTANTIATE_TEST_SUITE_P(Gl, Probe, both_backends(), name_of);

}  // namespace
}  // namespace pelage::testing
