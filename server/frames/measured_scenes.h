// Furred built-in models that are drawn to be measured, without a server's scenes.
#pragma once

#include <vector>

#include "base/status.h"
#include "protocol/commands/frame.h"
#include "renderer/frame/renderer.h"
#include "server/scene/scene.h"

namespace pelage {

struct MeasuredScene {
  SceneModel model;
  FieldSet fields;
  SceneSettings settings;

  SceneView view() const { return {model, fields, settings, 0}; }
};

/// A scene and the views that it is measured from: `distance` over that which frames the model.
struct CalibrationScene {
  BuiltinModel builtin;
  FirstGroom fur;
  Coat coat;
  int lights = 3;
  struct View {
    AutoView side = AutoView::three_quarter;
    float distance = 1;
    int size = 256;
  };
  std::vector<View> views;
};

/// Made and prepared as the server does it. `id` is unique in the renderer.
MeasuredScene make_measured_scene(const CalibrationScene& scene, std::uint64_t id);

/// Coats of different length, width, colour and form.
std::vector<CalibrationScene> calibration_scenes();

/// A frame with a transparent background, of a scene that the renderer has.
FurFrame measured_frame(const SceneView& scene, const CalibrationScene::View& view);

/// A frame's first picture, and the least of so many drawings in milliseconds, above 0.
struct TimedPicture {
  Image picture;
  double cost_ms = 0;  // FrameEstimate
  double cpu_ms = 0;   // of all threads
};

/// Draws the frame with the knobs. Fails as Renderer::draw does.
Result<TimedPicture> draw_often(Renderer& renderer, FurFrame frame, const Knobs& knobs, int repetitions);

}  // namespace pelage
