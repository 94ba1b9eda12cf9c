// A fixture that rasterizes views of a model while it is groomed.
#pragma once

#include <utility>
#include <vector>

#include "renderer/frame/raster_renderer.h"
#include "tests/frames/groomed_frames.h"

namespace pelage::testing {

class RasterViews : public GroomedFrames {
 protected:
  FurFrame frame_of(const FurredModel& model, const std::vector<DirtyRange>& dirty = {}) {
    return frame_for(raster, model, dirty);
  }

  Drawn drawn(const FurredModel& model, const std::vector<DirtyRange>& dirty = {}) {
    const FurFrame frame = frame_of(model, dirty);
    DrawTimes times;
    Result<Image> image = raster.draw(frame, nullptr, times, {});
    EXPECT_TRUE(image.ok()) << image.status().message;
    return {std::move(image).value(), times.counters.redrawn};
  }

  Drawn draw_after(const FurredModel& model, const std::vector<DirtyRange>& dirty) override {
    return drawn(model, dirty);
  }
  void forget_views() override { raster.clear_view_cache(); }

  /// Expects the same picture from a drawer that grows the fur at once and has seen no stroke.
  void expect_grown_at_once(const FurredModel& model) {
    const Image last = drawn(model).image;
    known.clear(), raster.forget_all();
    EXPECT_EQ(drawn(model).image.rgba, last.rgba);
  }

  RasterRenderer raster{2};
};

}  // namespace pelage::testing
