// A few whole pictures against ones that were looked at. After a wanted change run with PELAGE_UPDATE_GOLDEN=1, look at
// the new pictures and commit them on their own with the reason.

#include "tests/gl/with_renderer.h"
#include "tests/golden/expect_golden.h"
#include "tests/support/furred_model.h"

namespace pelage::testing {
namespace {

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

const Golden goldens[] = {
    {"creature_plush", {Builtin::creature, 4000}, {}, [](FurredModel&, FrameRequest&) {}, 0.5, 60},
    {"torus_sleek",
     {Builtin::torus, 3000},
     {.length = 0.02, .inclination = 0.9},
     [](FurredModel& model, FrameRequest&) {
       model.settings.coat.root_share = 0.7;
       model.settings.coat.clump = 0.25;
       model.settings.coat.ramp = {{0, {0.10f, 0.045f, 0.02f}}, {1, {0.28f, 0.13f, 0.06f}}};
     },
     0.5,
     60},
    {"knot_curly_white",
     {Builtin::knot, 6000},
     {.length = 0.05, .inclination = 0.3},
     [](FurredModel& model, FrameRequest& request) {
       model.settings.coat.curl = 0.12;
       model.settings.coat.lean_curve = LeanCurve::root;
       model.settings.coat.ramp = {{0, {0.75f, 0.72f, 0.68f}}, {1, {0.92f, 0.91f, 0.90f}}};
       request.background = Background::transparent;
     },
     0.5,
     60},
    {"creature_leopard_in_the_studio",
     {Builtin::creature, 4000},
     {.length = 0.025, .inclination = 0.7},
     [](FurredModel& model, FrameRequest& request) {
       model.settings.coat.pattern.kind = PatternKind::rosettes;
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

Image picture_of(Renderer& renderer, const Golden& golden, Method method) {
  FurredModel model = furred(golden.model, golden.fur);
  FrameRequest request = small_frame(AutoView::three_quarter, 320);
  request.knobs.method = method;
  request.tone_map = ToneMap::filmic;
  request.background = Background::colour;
  golden.change(model, request);
  return draw(renderer, model, request);
}

TEST(Pictures, OfStrandsMatchWhatWasLookedAt) {
  Renderer renderer{{.threads = 2}};
  for (const Golden& golden : goldens)
    expect_golden(picture_of(renderer, golden, Method::raster), golden.name, golden.mean, golden.largest);
}

class Shells : public WithRenderer {};

TEST_P(Shells, MatchWhatWasLookedAt) {
  for (const Golden& golden : goldens)
    expect_golden(picture_of(*renderer, golden, Method::shells), std::string("shells_") + golden.name, golden.mean,
                  golden.largest);
}

INSTANTIATE_TEST_SUITE_P(Golden, Shells, all_contexts(), name_of);

}  // namespace
}  // namespace pelage::testing
