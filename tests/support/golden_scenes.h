// The scenes of the golden pictures, which other tests draw too.
#pragma once

#include <vector>

#include "tests/support/furred_model.h"

namespace pelage::testing {

struct Golden {
  const char* name;
  BuiltinModel model;
  FirstGroom fur;
  void (*change)(FurredModel&, FrameRequest&);
  /// Thresholds in 1/255, chosen and not measured: one machine gives the same bytes, so today both could be 0. They
  /// leave room for the rounding of another Mesa and of other instruction sets: mean, half a step; largest, one strand
  /// that flips at the edge of a pixel.
  double mean;
  int largest;
};

inline const std::vector<Golden>& goldens() {
  static const std::vector<Golden> all{
      {"creature_plush", {Builtin::creature, 4000}, {}, [](FurredModel&, FrameRequest&) {}, 0.5, 60},
      {"torus_sleek",
       {Builtin::torus, 3000},
       {.length = 0.02, .inclination = 0.9},
       [](FurredModel& model, FrameRequest&) {
         model.settings.coats[0].coat.root_share = 0.7;
         model.settings.coats[0].coat.clump = 0.25;
         model.settings.coats[0].coat.ramp = {{0, {0.10f, 0.045f, 0.02f}}, {1, {0.28f, 0.13f, 0.06f}}};
       },
       0.5,
       60},
      {"knot_curly_white",
       {Builtin::knot, 6000},
       {.length = 0.05, .inclination = 0.3},
       [](FurredModel& model, FrameRequest& request) {
         model.settings.coats[0].coat.curl = 0.12;
         model.settings.coats[0].coat.lean_curve = LeanCurve::root;
         model.settings.coats[0].coat.ramp = {{0, {0.75f, 0.72f, 0.68f}}, {1, {0.92f, 0.91f, 0.90f}}};
         request.background = Background::transparent;
       },
       0.5,
       60},
      {"creature_leopard_in_the_studio",
       {Builtin::creature, 4000},
       {.length = 0.025, .inclination = 0.7},
       [](FurredModel& model, FrameRequest& request) {
         model.settings.coats[0].coat.pattern.kind = PatternKind::rosettes;
         model.settings.look.shading = ShadingModel::energy_conserving;
         model.settings.look.colour_source = ColourSource::coat;
         model.settings.environment.horizon = {0.8f, 0.82f, 0.85f};
         model.settings.environment.ground = {0.5f, 0.48f, 0.45f};
         model.settings.ground.visible = true;
         request.knobs.shells.shadow_maps = true;
       },
       0.5,
       60},
  };
  return all;
}

/// The model and the request of a golden picture, at its own or another size.
struct GoldenScene {
  FurredModel model;
  FrameRequest request;

  explicit GoldenScene(const Golden& golden, int size = 320)
      : model(furred(golden.model, golden.fur)), request(small_frame(AutoView::three_quarter, size)) {
    request.tone_map = ToneMap::filmic;
    request.background = Background::colour;
    golden.change(model, request);
  }
};

}  // namespace pelage::testing
