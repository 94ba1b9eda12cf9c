// Scenes that are drawn to be measured, and measuring them.
//
// Furred models that are drawn to be measured, without a server's scenes.
#pragma once

#include <span>
#include <vector>

#include "protocol/base/status.h"
#include "protocol/commands/frame.h"
#include "renderer/frame/renderer.h"
#include "renderer/quality/fit.h"
#include "server/frames/frame_queue.h"
#include "server/scene/scene.h"

namespace pelage {

struct MeasuredScene {
  SceneModel model;
  FieldSet fields;
  SceneSettings settings;

  SceneView view() const { return {model, fields, settings, 0}; }
};

/// A prepared mesh with its patches and first groom. `id` is unique in the renderer.
MeasuredScene make_measured_scene(Mesh mesh, const FirstGroom& fur, std::uint64_t id);

/// A scene of the calibration and the views that it is measured from: `distances` over that which frames the model.
struct CalibrationScene {
  BuiltinModel builtin;
  FirstGroom fur;
  Coat coat;
  ShadingModel shading = ShadingModel::kajiya;
  struct View {
    AutoView side = AutoView::three_quarter;
    float distance = 1;
    int size = 256;
  };
  std::vector<View> views;
};

/// Made and prepared as the server does it.
MeasuredScene make_measured_scene(const CalibrationScene& scene, std::uint64_t id);

/// Built-in models with coats of different length, width, colour and form. The order mixes models, so that a beginning
/// of it has some of all.
std::vector<CalibrationScene> calibration_scenes();

// Drawing a view with every knob set of a ladder: what each costs, and how far it is from the reference.

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
