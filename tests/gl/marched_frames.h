// Tests of frames that are marched: a drawer of its own for each.
#pragma once

#include <utility>
#include <vector>

#include "renderer/frame/marched_renderer.h"
#include "tests/gl/groomed_frames.h"

namespace pelage::testing {

class MarchedFrames : public GroomedFrames {
 protected:
  Drawn drawn(const FurredModel& model, const std::vector<DirtyRange>& dirty = {}, const Pause& pause = {}) {
    const FurFrame frame = frame_of(model, dirty);
    DrawTimes times;
    Result<Image> image = marched.draw(frame, &times, pause);
    EXPECT_TRUE(image.ok()) << image.status().message;
    return {std::move(image).value(), times.counters.redrawn};
  }

  FurFrame frame_of(const FurredModel& model, const std::vector<DirtyRange>& dirty = {}) {
    return frame_for(marched, model, dirty);
  }

  Drawn draw_after(const FurredModel& model, const std::vector<DirtyRange>& dirty) override {
    return drawn(model, dirty);
  }
  void forget_views() override { marched.clear_view_cache(); }

  MarchedRenderer marched{2};
};

}  // namespace pelage::testing
