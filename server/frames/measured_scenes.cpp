#include "server/frames/measured_scenes.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "server/builtin/builtin.h"
#include "server/frames/fur_view.h"
#include "server/groom/first_groom.h"
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

MeasuredScene make_measured_scene(const CalibrationScene& scene, std::uint64_t id) {
  Result<Mesh> mesh = prepare(make_builtin(scene.builtin));
  assert(mesh);  // built-in models are valid
  PatchMap patches = lay_patches(*mesh);
  FieldSet fields = first_groom(*mesh, scene.fur);
  MeasuredScene made{{Surface(std::move(mesh).value()), std::move(patches), id, "measured"}, std::move(fields), {}};
  made.settings.coats.front().coat = scene.coat;
  made.settings.lights.resize(static_cast<std::size_t>(scene.lights), made.settings.lights.front());
  return made;
}

std::vector<CalibrationScene> calibration_scenes() {
  using enum AutoView;
  const Coat brown, white = coat_of(0.8, 2.6f, 0.2), dark = coat_of(1.4, 0.25f, 0.5), fine = coat_of(0.5, 1.0f, 0.6);
  return {
      {{Builtin::creature, 5000}, {.length = 0.03}, brown, 3, {{three_quarter, 1, 256}, {back, 1.6f, 192}}},
      {{Builtin::torus, 3000}, {.length = 0.03}, brown, 3, {{three_quarter, 1, 192}, {front, 0.6f, 384}}},
      {{Builtin::sphere, 2000}, {.length = 0.05}, white, 3, {{front, 1, 192}, {three_quarter, 2, 192}}},
      {{Builtin::knot, 4000}, {.length = 0.02}, dark, 6, {{left, 0.8f, 192}}},
      {{Builtin::plane, 800}, {.length = 0.04}, brown, 3, {{three_quarter, 1, 192}, {top, 0.8f, 192}}},
      {{Builtin::creature, 12000}, {.length = 0.015}, white, 3, {{left, 1, 192}}},
      {{Builtin::torus, 1000}, {.length = 0.08}, fine, 1, {{front, 1, 192}}},
      {{Builtin::knot, 8000}, {.length = 0.05}, white, 3, {{back, 1.5f, 192}}},
      {{Builtin::sphere, 6000}, {.length = 0.015}, dark, 3, {{three_quarter, 0.6f, 192}}},
      {{Builtin::creature, 3000}, {.length = 0.05}, striped(brown), 3, {{three_quarter, 1, 384}, {left, 0.6f, 384}}},
      {{Builtin::torus, 5000}, {.length = 0.02}, dark, 6, {{three_quarter, 1, 192}, {left, 0.7f, 192}}},
      {{Builtin::plane, 2000}, {.length = 0.02}, striped(white), 1, {{three_quarter, 0.7f, 192}}},
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

Result<TimedPicture> draw_timed(Renderer& renderer, FurFrame frame, const Knobs& knobs, int repetitions) {
  constexpr double min_cost = 1e-3;
  frame.knobs = knobs;
  Result<TimedPicture> timed = failure(Code::internal, "no repetition");
  for (int i = 0; i < repetitions; ++i) {
    DrawTimes times;
    renderer.clear_view_cache();
    Result<Image> image = renderer.draw(frame, &times);
    if (!image) return image.status();
    const double cost = std::max(times.draw, min_cost), cpu = std::max(times.cpu, min_cost);
    if (i == 0) timed = TimedPicture{std::move(image).value(), cost, cpu};
    timed->cost_ms = std::min(timed->cost_ms, cost), timed->cpu_ms = std::min(timed->cpu_ms, cpu);
  }
  return timed;
}

}  // namespace pelage
