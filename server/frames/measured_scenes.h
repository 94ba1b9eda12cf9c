// Furred built-in models for measurements, without a server's scenes.
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

/// A scene and the views that it is measured from. `distance` is relative to the distance that frames the model.
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

/// Makes a scene as the server does. `id` must be unique in the renderer.
MeasuredScene make_measured_scene(const CalibrationScene& scene, std::uint64_t id);

/// Returns scenes with coats of different length, width, colour and form.
std::vector<CalibrationScene> calibration_scenes();

/// Returns a frame with a transparent background.
FurFrame measured_frame(const SceneView& scene, const CalibrationScene::View& view);

/// A frame's picture, and the minimum cost of several drawings in milliseconds, above 0.
struct TimedPicture {
  Image picture;
  double cost_ms = 0;  // FrameEstimate
  double cpu_ms = 0;   // CPU time of all threads
};

/// Draws the frame `repetitions` times with the knobs. Fails as Renderer::draw does.
Result<TimedPicture> draw_timed(Renderer& renderer, FurFrame frame, const Knobs& knobs, int repetitions);

}  // namespace pelage
