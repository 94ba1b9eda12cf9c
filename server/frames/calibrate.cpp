#include "server/frames/calibrate.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <vector>

#include "renderer/quality/dial_model.h"
#include "server/frames/frame_planner.h"
#include "server/frames/frame_queue.h"
#include "server/frames/fur_view.h"
#include "server/frames/measured_scenes.h"

namespace pelage {

namespace {

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm date{};
  gmtime_r(&now, &date);
  return fmt::format("{:04}-{:02}-{:02}", date.tm_year + 1900, date.tm_mon + 1, date.tm_mday);
}

}  // namespace

Result<double> measure_cost_ratio(Renderer& renderer) {
  constexpr std::size_t every = 2;  // uses every second row of the dial
  constexpr int repetitions = 3;
  const DialModel& model = default_model();
  std::vector<double> ratios;
  std::uint64_t id = 0;
  for (const CalibrationScene& described : calibration_scenes()) {
    const MeasuredScene scene = make_measured_scene(described, ++id);
    sync_scene(renderer, scene.view(), {});
    const FurFrame frame = measured_frame(scene.view(), described.views.front());
    const ViewFeatures view = view_features(frame, furred_skin(scene.view()));
    for (std::size_t row = 0; row < model.rows.size(); row += every) {
      const Knobs& knobs = model.rows[row].knobs;
      const Result<TimedPicture> timed = draw_timed(renderer, frame, knobs, repetitions);
      if (!timed) return timed.status();
      ratios.push_back(timed->cost_ms / predicted_cost(model, view, knobs));
    }
    renderer.forget(id);
  }
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  return *middle;
}

Status calibrate_machine(GlChoice gl, int threads, const std::string& file) {
  const Result<std::unique_ptr<Context>> context = select_context(gl, threads);
  if (!context) return context.status();
  const int used = drawing_threads(threads);
  const Result<std::unique_ptr<Renderer>> renderer = make_renderer(context->get(), used);
  if (!renderer) return renderer.status();
  fmt::print(stderr, "Calibrating {}\n", drawn_by(context->get(), (*renderer)->strands_by_gl()));
  const Result<double> price = measure_cost_ratio(**renderer);
  if (!price) return price.status();
  std::error_code error;
  if (const auto folder = std::filesystem::path(file).parent_path(); !folder.empty())
    std::filesystem::create_directories(folder, error);
  const Calibration measured{today(), drawn_by(context->get(), (*renderer)->strands_by_gl()), used, *price};
  if (Status written = write_calibration(file, measured); !written.ok()) return written;
  fmt::print(stderr, "Stored in {}; a server reads it when it starts. Frames take {:.2f} times the defaults.\n", file,
             *price / default_calibration(used).price);
  return {};
}

}  // namespace pelage
