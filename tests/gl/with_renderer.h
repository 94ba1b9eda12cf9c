// A fixture with a renderer of shells on each backend.
#pragma once

#include "server/frames/fur_view.h"
#include "tests/gl/backends.h"
#include "tests/support/furred_model.h"

namespace pelage::testing {

/// A small frame of shells.
inline FrameRequest shells_frame(AutoView view = AutoView::front, int size = 128) {
  FrameRequest request = small_frame(view, size);
  request.knobs.method = Method::shells;
  return request;
}

/// Syncs what shells of the model need.
inline UploadCount sync_shells(Renderer& renderer, const FurredModel& model, const std::vector<VertexRange>& dirty) {
  return sync_scene(renderer, model.view(), dirty, nullptr, true);
}

class WithRenderer : public OnBackend {
 protected:
  void SetUp() override {
    OnBackend::SetUp();
    if (!context) return;
    const Result<Renderer*> made = stage.renderer(GetParam());
    ASSERT_TRUE(made.ok()) << made.status().message;
    renderer = *made;
  }

  Renderer* renderer = nullptr;
};

}  // namespace pelage::testing
