#include "server/calibration/calibrate.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>

#include "protocol/base/stopwatch.h"
#include "server/frames/frame_planner.h"
#include "server/frames/fur_view.h"

namespace pelage {

namespace {

struct Row {
  ShellPolicy policy;
  int shells, steps;
  double scale;
};

constexpr auto uniform = ShellPolicy::uniform, adaptive = ShellPolicy::adaptive;
constexpr Row rows[] = {{uniform, 4, 4, .25}, {uniform, 4, 4, .35}, {uniform, 4, 4, .5}, {uniform, 4, 4, .7},
                        {adaptive, 8, 2, .7}, {uniform, 4, 4, 1},   {adaptive, 8, 2, 1}, {uniform, 8, 3, 1},
                        {uniform, 12, 2, 1},  {adaptive, 16, 2, 1}, {uniform, 24, 2, 1}, {adaptive, 32, 2, 1},
                        {uniform, 32, 2, 1},  {uniform, 48, 3, 1},  {uniform, 64, 4, 1}};

}  // namespace

std::vector<Knobs> candidate_ladder() {
  std::vector<Knobs> ladder{knobs_of(Tier::interactive)};
  for (const Row& row : rows) {
    Knobs knobs = knobs_of(Tier::interactive);
    knobs.shells = row.shells, knobs.steps = row.steps, knobs.scale = row.scale;
    knobs.shell_policy = row.policy;
    ladder.push_back(knobs);
  }
  return ladder;
}

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

namespace {

constexpr int bar_width = 40;

/// On a terminal one line that grows; elsewhere a line for each tenth.
class ProgressBar {
 public:
  void show(double share) {
    if (isatty(STDERR_FILENO)) {
      const auto full = static_cast<std::size_t>(share * bar_width);
      fmt::print(stderr, "\rMeasuring [{:<{}}] {:3.0f}%{}", std::string(full, '#'), bar_width, share * 100,
                 share < 1 ? "" : "\n");
    } else if (const int tenth = static_cast<int>(share * 10); tenth > tenth_) {
      tenth_ = tenth;
      fmt::print(stderr, "Measuring: {}%\n", tenth * 10);
    }
    std::fflush(stderr);
  }

 private:
  int tenth_ = 0;
};

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm date{};
  gmtime_r(&now, &date);
  return fmt::format("{:04}-{:02}-{:02}", date.tm_year + 1900, date.tm_mon + 1, date.tm_mday);
}

}  // namespace

Status calibrate_machine(GlChoice gl, int threads, const std::string& file) {
  const Result<std::unique_ptr<Context>> context = select_context(gl, threads);
  if (!context) return context.status();
  const CostUnit unit = cost_unit((*context)->is_software(), threads);
  const Result<std::unique_ptr<Renderer>> renderer = Renderer::create((*context)->gl(), renderer_options(unit));
  if (!renderer) return renderer.status();
  fmt::print(stderr, "Calibrating {}\n", drawn_by(**context));
  ProgressBar bar;
  Result<Calibration> measured =
      calibrate(**renderer, unit, default_calibration(), [&](double share) { bar.show(share); });
  if (!measured) return measured.status();
  measured->name = today(), measured->machine = drawn_by(**context), measured->threads = unit.threads;
  std::error_code error;
  if (const auto folder = std::filesystem::path(file).parent_path(); !folder.empty())
    std::filesystem::create_directories(folder, error);
  if (Status written = write_calibration(file, *measured); !written.ok()) return written;
  fmt::print(stderr,
             "Stored in {}; a server reads it when it starts. 95% of measured frames cost at most {:.2f} times their "
             "estimate.\n",
             file, measured->cost_safety);
  return {};
}

}  // namespace pelage
