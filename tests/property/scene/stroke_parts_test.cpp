// A stroke that is sent in parts, against the same stroke sent whole.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "base/random.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage {
namespace {

using PartsTest = StoreTest;

/// Sends one stroke whole to one scene and in random parts to another.
void send_whole_and_in_parts(Random random, Scene& sent_whole, Scene& live, Comb whole) {
  const glm::dvec3 start = std::get<PositionSample>(whole.stroke->samples[0].position).position;
  whole.stroke->samples.clear();
  const bool drawn = random.uniform() < 0.4;
  if (drawn) whole.stroke->view = View{.camera = {.automatic = AutoView::front}, .width = 400, .height = 400};
  for (int i = 0; i < 20; ++i) {
    StrokeSample sample;
    const double away = random.uniform() < 0.2 ? 5 : 0;  // sometimes the pointer leaves the model
    sample.position = PositionSample{start + 0.02 * i * glm::dvec3(1, 0.5, -0.4) + away};
    if (drawn) sample.position = ScreenSample{{away > 0 ? 0 : 60 + 14 * i, 200 + 6 * i}};
    whole.stroke->samples.push_back(sample);
  }
  RC_ASSERT(sent_whole.execute({whole}).ok());
  std::size_t at = 0;
  for (std::uint32_t part = 0; at < whole.stroke->samples.size(); ++part) {
    const std::size_t end = std::min(at + 1 + static_cast<std::size_t>(random.uniform(0, 6)), std::size_t{20});
    Comb part_command = whole;
    part_command.stroke->id = "pen";
    part_command.stroke->part = part;
    part_command.stroke->last = end == 20;
    part_command.stroke->samples.assign(whole.stroke->samples.begin() + static_cast<std::ptrdiff_t>(at),
                                        whole.stroke->samples.begin() + static_cast<std::ptrdiff_t>(end));
    RC_ASSERT(live.execute({part_command}).ok());
    at = end;
  }
}

TEST_F(PartsTest, AnyPartsOfAStrokeGiveTheWhole) {
  const bool held = rc::check([this](std::uint64_t seed) {
    Random random(seed);
    const auto live = make(Builtin::torus, 400), sent_whole = make(Builtin::torus, 400);
    const auto anew = make(Builtin::torus, 400);
    Comb whole = comb_at(*live, static_cast<std::size_t>(random.uniform(0, 200)));
    if (random.uniform() < 0.5) whole.brush.reach = Reach::fur;
    send_whole_and_in_parts(random, *sent_whole, *live, whole);
    RC_ASSERT(hash(*live) == hash(*sent_whole));
    RC_ASSERT(live->summary().undo_steps == sent_whole->summary().undo_steps);
    for (const auto& step : live->effective_log()) RC_ASSERT(anew->execute(step).ok());
    RC_ASSERT(hash(*anew) == hash(*live));
    for (const auto& scene : {live, sent_whole, anew}) RC_ASSERT(store_->remove(scene->id()).ok());
  });
  EXPECT_TRUE(held);
}

}  // namespace
}  // namespace pelage
