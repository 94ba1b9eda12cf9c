// Drawing a view with every knob set of a ladder: what each costs, and how far it is from the reference.
#pragma once

#include <span>

#include "protocol/base/status.h"
#include "renderer/frame/renderer.h"
#include "renderer/quality/fit.h"
#include "server/calibration/measured_scene.h"
#include "server/frames/frame_cost.h"

namespace pelage {

struct MeasureOptions {
  int truth_shells = 256;  // sorted, of the reference; 0 measures no errors
  int repetitions = 2;     // draws of each knob set, of which the least cost counts
  int probed = 0;          // asks an ErrorProbe too for each so many'th knob set; 0 none
};

/// A frame with a transparent background, of a scene that the renderer has.
FurFrame measured_frame(const SceneView& scene, const CalibrationScene::View& view);

/// Draws the view with each knob set of the ladder and with the reference. Fails as Renderer::draw does, and (invalid)
/// where nothing is seen.
Result<MeasuredView> measure_view(Renderer& renderer, const CostUnit& unit, const SceneView& scene,
                                  const FurFrame& frame, std::span<const Knobs> ladder,
                                  const MeasureOptions& options = {});

}  // namespace pelage
