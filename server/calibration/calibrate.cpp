#include "server/calibration/calibrate.h"

#include <algorithm>

#include "protocol/base/stopwatch.h"
#include "server/frames/fur_view.h"

namespace pelage {

namespace {

std::size_t count_views(const std::vector<CalibrationScene>& scenes) {
  std::size_t count = 0;
  for (const CalibrationScene& scene : scenes) count += scene.views.size();
  return count;
}

}  // namespace

Result<Calibration> calibrate(Renderer& renderer, const CostUnit& unit, const Calibration& defaults,
                              const std::function<void(double)>& progress, const CalibrateOptions& options) {
  const Stopwatch passed;
  std::vector<Knobs> ladder;
  for (const CalibratedKnobs& row : defaults.ladder) ladder.push_back(row.knobs);
  const std::vector<CalibrationScene> scenes = calibration_scenes();
  const double count = static_cast<double>(count_views(scenes));
  std::vector<MeasuredView> views;
  const auto out_of_time = [&] { return views.size() >= options.min_views && passed.seconds() > options.seconds; };
  for (std::size_t i = 0; i < scenes.size() && !out_of_time(); ++i) {
    const MeasuredScene scene = make_measured_scene(scenes[i], i + 1);
    sync_scene(renderer, scene.view(), {});
    for (const CalibrationScene::View& view : scenes[i].views) {
      if (out_of_time()) break;
      Result<MeasuredView> measured = measure_view(renderer, unit, scene.view(), measured_frame(scene.view(), view),
                                                   ladder, {.truth_shells = 0, .repetitions = 2});
      if (!measured) return measured.status();
      views.push_back(std::move(measured).value());
      const double by_time = passed.seconds() / options.seconds;
      progress(std::min(0.99, std::max(by_time, static_cast<double>(views.size()) / count)));
    }
    renderer.forget(scene.model.id);
  }
  progress(1);
  return fit_costs(defaults, views);
}

}  // namespace pelage
