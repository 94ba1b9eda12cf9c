// Draws and encodes a frame with a frame service, in the steps that a server takes.
#pragma once

#include <memory>
#include <utility>

#include "server/frames/frame_service.h"

namespace pelage::testing {

inline Result<FrameAnswer> drawn_frame(FrameService& frames, const std::shared_ptr<Scene>& scene,
                                       const FrameRequest& request) {
  Result<FrameView> view = frames.view(*scene, request);
  if (!view) return view.status();
  Result<FramePlan> plan = frames.plan(*view, request);
  if (!plan) return plan.status();
  Result<DrawnFrame> drawn = frames.draw({scene, request, std::move(*view), std::move(*plan)});
  return drawn ? frames.encode(std::move(*drawn), request) : Result<FrameAnswer>(drawn.status());
}

}  // namespace pelage::testing
