// What a drawn frame has cost, and what a view's estimates are estimated from.
#pragma once

#include "protocol/commands/frame.h"
#include "renderer/frame/renderer.h"
#include "renderer/quality/view_features.h"
#include "server/scene/scene.h"

namespace pelage {

/// What turns the times of a drawn frame into its cost (FrameEstimate).
struct CostUnit {
  bool software = true;  // GL: its CPU time counts, else the time that passes
  int threads = 1;       // of a software GL

  double of(const DrawTimes& times) const { return software ? times.cpu / threads : times.shadow + times.draw; }
};
/// `threads` as of select_context: 0 for all cores.
CostUnit cost_unit(bool software, int threads);

/// Milliseconds that a frame of shells may take, above 0: a guess before its view is known, to order requests by.
double expected_cost(const FrameRequest& request);

/// Views of the scene.
FurredSkin furred_skin(const SceneView& scene);

}  // namespace pelage
