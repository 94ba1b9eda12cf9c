#include "server/calibration/measure.h"

#include <algorithm>
#include <cassert>
#include <optional>

#include "server/builtin/builtin.h"
#include "server/frames/error_probe.h"
#include "server/frames/fur_view.h"
#include "server/patches/patches.h"
#include "server/surface/prepare.h"

namespace pelage {

namespace {

Coat coat_of(double width, float lightness, double clump) {
  Coat coat;
  coat.width_root *= width, coat.width_tip *= width;
  coat.clump = clump;
  for (RampStop& stop : coat.ramp) stop.colour = glm::min(stop.colour * lightness, glm::vec3(0.95f));
  return coat;
}

Coat striped(Coat coat) {
  coat.pattern.kind = PatternKind::stripes;
  coat.tufts.gather = 0.5;
  return coat;
}

}  // namespace

MeasuredScene make_measured_scene(Mesh mesh, const FirstGroom& fur, std::uint64_t id) {
  PatchMap patches = lay_patches(mesh);
  FieldSet fields = first_groom(mesh, fur);
  return {{Surface(std::move(mesh)), std::move(patches), id, "measured"}, std::move(fields), {}};
}

MeasuredScene make_measured_scene(const CalibrationScene& scene, std::uint64_t id) {
  Result<Mesh> mesh = prepare(make_builtin(scene.builtin), Axis::plus_y, Axis::plus_z, false);
  assert(mesh);  // a built-in can be prepared
  MeasuredScene made = make_measured_scene(std::move(mesh).value(), scene.fur, id);
  made.settings.coat = scene.coat, made.settings.look.shading = scene.shading;
  return made;
}

std::vector<CalibrationScene> calibration_scenes() {
  using enum AutoView;
  const Coat brown, white = coat_of(0.8, 2.6f, 0.2), dark = coat_of(1.4, 0.25f, 0.5), fine = coat_of(0.5, 1.0f, 0.6);
  const auto kajiya = ShadingModel::kajiya;
  return {
      {{Builtin::creature, 5000}, {.length = 0.03}, brown, kajiya, {{three_quarter, 1, 256}, {back, 1.6f, 192}}},
      {{Builtin::torus, 3000}, {.length = 0.03}, brown, kajiya, {{three_quarter, 1, 192}, {front, 0.6f, 192}}},
      {{Builtin::sphere, 2000}, {.length = 0.05}, white, kajiya, {{front, 1, 192}, {three_quarter, 2, 192}}},
      {{Builtin::knot, 4000}, {.length = 0.02}, dark, kajiya, {{left, 0.8f, 192}}},
      {{Builtin::plane, 800}, {.length = 0.04}, brown, kajiya, {{three_quarter, 1, 192}, {top, 0.8f, 192}}},
      {{Builtin::creature, 12000}, {.length = 0.015}, white, kajiya, {{left, 1, 192}}},
      {{Builtin::torus, 1000}, {.length = 0.08}, fine, kajiya, {{front, 1, 192}}},
      {{Builtin::knot, 8000}, {.length = 0.05}, white, kajiya, {{back, 1.5f, 192}}},
      {{Builtin::sphere, 6000}, {.length = 0.015}, dark, kajiya, {{three_quarter, 0.6f, 192}}},
      {{Builtin::creature, 3000}, {.length = 0.05}, striped(brown), kajiya, {{three_quarter, 1, 192}}},
      {{Builtin::torus, 5000},
       {.length = 0.02},
       dark,
       ShadingModel::energy_conserving,
       {{three_quarter, 1, 192}, {left, 0.7f, 192}}},
      {{Builtin::plane, 2000}, {.length = 0.02}, striped(white), kajiya, {{three_quarter, 0.7f, 192}}},
  };
}

FurFrame measured_frame(const SceneView& scene, const CalibrationScene::View& view) {
  FrameRequest request;
  request.width = request.height = view.size;
  request.camera.automatic = view.side;
  request.background = Background::transparent;
  FurFrame frame = make_frame(scene, request);
  frame.camera.position *= view.distance;
  return frame;
}

namespace {

FurFrame with(FurFrame frame, const Knobs& knobs) {
  frame.knobs = knobs;
  return frame;
}

/// The first picture, and the least cost.
Result<Image> draw_often(Renderer& renderer, const CostUnit& unit, const FurFrame& frame, int repetitions,
                         double& cost) {
  Result<Image> first = failure(Code::internal, "no repetition");
  cost = 1e30;
  for (int i = 0; i < repetitions; ++i) {
    DrawTimes times;
    renderer.clear_view_cache();
    Result<Image> image = renderer.draw(frame, &times);
    if (!image) return image;
    cost = std::min(cost, std::max(unit.of(times), 1e-3));
    if (i == 0) first = std::move(image);
  }
  return first;
}

}  // namespace

Result<MeasuredView> measure_view(Renderer& renderer, const CostUnit& unit, const SceneView& scene,
                                  const FurFrame& frame, std::span<const Knobs> ladder, const MeasureOptions& options) {
  MeasuredView measured;
  measured.features = view_features(frame, furred_skin(scene));
  std::optional<Image> truth;
  if (options.truth_shells > 0) {
    Result<Image> drawn = renderer.draw(with(frame, reference_knobs(options.truth_shells)));
    if (!drawn) return drawn.status();
    truth = std::move(drawn).value();
  }
  for (const Knobs& knobs : ladder) {
    double cost = 0;
    const Result<Image> image = draw_often(renderer, unit, with(frame, knobs), options.repetitions, cost);
    if (!image) return image.status();
    measured.cost_ms.push_back(cost);
    if (!truth) continue;
    const std::optional<FurError> error = fur_error(*truth, *image);
    if (!error) return failure(Code::invalid, "nothing is seen in a view that was to be measured");
    measured.error.push_back(error->mean);
  }
  measured.probed_error.resize(ladder.size());
  ErrorProbe probe(renderer, frame, measured.features.places, std::max(options.truth_shells, 1));
  for (std::size_t row = 0; options.probed > 0 && row < ladder.size(); row += static_cast<std::size_t>(options.probed))
    measured.probed_error[row] = probe.error(ladder[row]).value_or(0);
  return measured;
}

}  // namespace pelage
