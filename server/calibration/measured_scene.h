// Furred models that are drawn to be measured, without a server's scenes.
#pragma once

#include <vector>

#include "protocol/commands/frame.h"
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

}  // namespace pelage
