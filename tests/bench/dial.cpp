// Fits the default model of the quality dial on built-in models, and judges it on models that the fit has not seen.
// usage: bench_dial fit FILE [--scenes N] [--repetitions N] [--threads N] [--passes N]
//          draws the calibration's scenes with all rows and writes the model's code (renderer/quality/defaults.cpp)
//        bench_dial judge FOLDER [--size PIXELS] [--repetitions N] [--threads N]
//          draws models of a folder with the rows and with settings between them, and reports how often budgets and
//          errors are met and how far the choices are from the best ones
// A cost is the minimum over the repetitions. Without --threads it is the CPU time of one thread, which equals the
// wall-clock time on an idle machine. With --threads it is the wall-clock time, and `judge` first measures the
// machine's cost factor, as `pelage calibrate` does.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "renderer/compare/compare.h"
#include "renderer/quality/planner.h"
#include "server/frames/calibrate.h"
#include "server/frames/frame_queue.h"
#include "server/frames/fur_view.h"
#include "server/frames/measured_scenes.h"
#include "tests/bench/dial_fit.h"
#include "tests/bench/measure.h"
#include "tests/bench/traced.h"

namespace pelage::bench {
namespace {

/// The rows of the dial, from the coarsest to the closest to the truth. The tier `interactive` is one of them, so that
/// its frames have an estimate.
std::vector<Knobs> rows() {
  return {dial_knobs(.4, 8, .25), dial_knobs(.4, 8, .5), dial_knobs(.3, 4, .7), dial_knobs(.4, 4, 1),
          dial_knobs(1.4, 4, 1),  dial_knobs(4, 3, 1),   dial_knobs(1.4, 4, 2), dial_knobs(1000, 3, 2)};
}

/// The rows, then settings between them that the dial could have chosen.
std::vector<Knobs> candidates() {
  std::vector<Knobs> all = rows();
  for (const Knobs& knobs : {dial_knobs(.2, 8, .35), dial_knobs(1, 4, .5), dial_knobs(.7, 4, .7), dial_knobs(.8, 4, 1),
                             dial_knobs(2.5, 3, 1), dial_knobs(1000, 3, 1), dial_knobs(.8, 4, 2)})
    all.push_back(knobs);
  return all;
}

template <class T>
T value_or_end(Result<T> result) {
  if (!result) std::fprintf(stderr, "%s\n", result.status().message.c_str()), std::exit(1);
  return std::move(result).value();
}

/// Mean FLIP against traced strands, over the fur of both pictures; at least 1e-5.
double error_of(const Image& truth, const Image& test) {
  constexpr double min_error = 1e-5;
  const FloatImage expected = linear_image(truth), drawn = linear_image(test);
  const Mask mask = union_of(alpha_mask(expected), alpha_mask(drawn));
  return std::max(min_error, value_or_end(compare(expected, drawn, mask)).figures->flip.mean);
}

Image truth_of(Renderer& renderer, const SceneView& scene, FurFrame frame, int passes) {
  frame.knobs = knobs_of(Tier::reference);
  frame.knobs.trace.passes = passes, frame.knobs.trace.filter = false;
  return value_or_end(renderer.finish(frame, traced_light(renderer, scene, frame)));
}

struct Measuring {
  int repetitions = 1;
  int threads = 0;  // above 0: costs are wall-clock time on so many threads; 0: CPU time of one thread
  int passes = 64;  // passes of the traced truth
};

MeasuredView measure_view(Renderer& renderer, const SceneView& scene, const FurFrame& frame,
                          std::span<const Knobs> knobs, const Measuring& how) {
  const Image truth = truth_of(renderer, scene, frame, how.passes);
  MeasuredView measured{view_features(frame, furred_skin(scene)), {}, {}};
  const ViewFeatures& f = measured.features;
  fmt::print("  pixels {:.0f}, area {:.0f}, fur {:.2f}, lights {:.0f}, strands {:.0f}, width {:.3f}\n", f.pixels,
             f.area, f.fur_pixels, f.lights, f.strands, f.width_pixels);
  for (const Knobs& one : knobs) {
    const TimedPicture timed = value_or_end(draw_timed(renderer, frame, one, how.repetitions));
    measured.cost_ms.push_back(how.threads > 0 ? timed.cost_ms : timed.cpu_ms);
    measured.error.push_back(error_of(truth, timed.picture));
    fmt::print("    {:6} a pixel, light of {}, scale {:.2f}: {:8.2f} ms, FLIP {:.4f}\n", one.raster.strands,
               one.raster.light_of, one.scale, measured.cost_ms.back(), measured.error.back());
  }
  std::fflush(stdout);
  return measured;
}

void write_defaults(const DialModel& model, const std::string& file) {
  std::string text =
      "// Written by `bench_dial fit`, then formatted.\n#include \"renderer/quality/dial_model.h\"\n\n"
      "namespace pelage {\n\nconst DialModel& default_model() {\n  static const DialModel model{\n";
  text += fmt::format("      .coefficients = {{{:.4g}}},\n", fmt::join(model.coefficients, ", "));
  text += fmt::format("      .cost_safety = {:.3f},\n      .learnt_safety = {:.3f},\n", model.cost_safety,
                      model.learnt_safety);
  text += fmt::format("      .min_fur = {:.3g},\n      .max_fur = {:.3g},\n      .rows = {{\n", model.min_fur,
                      model.max_fur);
  for (const DialRow& row : model.rows)
    text += fmt::format("          {{dial_knobs({}, {}, {}), {:.4g}, {:.3f}, {:.3f}}},\n", row.knobs.raster.strands,
                        row.knobs.raster.light_of, row.knobs.scale, row.error, row.growth, row.safety);
  std::ofstream(file) << text << "      }};\n  return model;\n}\n\n}  // namespace pelage\n";
}

void fit_defaults(Renderer& renderer, const std::string& file, std::size_t scenes, const Measuring& how) {
  std::vector<MeasuredView> views;
  std::uint64_t id = 0;
  for (const CalibrationScene& described : calibration_scenes()) {
    if (id >= scenes) break;
    const MeasuredScene scene = make_measured_scene(described, ++id);
    sync_scene(renderer, scene.view(), {});
    for (const CalibrationScene::View& view : described.views)
      views.push_back(measure_view(renderer, scene.view(), measured_frame(scene.view(), view), rows(), how));
    renderer.forget(id);
  }
  write_defaults(fit(rows(), views), file);
}

/// Counts how often frames stay within the dial's estimates, and how far its choices are from the best ones.
struct Tally {
  int within = 0;
  std::vector<double> ratios = {};  // error or cost of the dial's choice over that of the best candidate

  void add(bool is_within, double ratio) { within += is_within, ratios.push_back(ratio); }
  void print(const char* what, const char* ratio) {
    std::sort(ratios.begin(), ratios.end());
    const std::size_t count = ratios.size();
    if (count)
      fmt::print("{}: {} frames, within {:.1f}%; {} median {:.2f}, 95% {:.2f}\n", what, count,
                 100.0 * within / static_cast<double>(count), ratio, ratios[count / 2], ratios[count * 95 / 100]);
  }
};

/// Asks the dial for many budgets and errors in measured views, and compares its choices with the best candidates.
class Judge {
 public:
  explicit Judge(Calibration machine) : machine_(std::move(machine)) {}
  void judge(const MeasuredView& view);
  void print();

 private:
  std::size_t chosen(const MeasuredView& view, const CostCorrection& correction, const PlanGoal& goal) const;
  CostCorrection learnt(const MeasuredView& view) const;
  void budgets(const MeasuredView& view, const CostCorrection& correction, Tally& tally) const;
  void errors(const MeasuredView& view);

  Calibration machine_;
  const std::vector<Knobs> candidates_ = candidates();
  Tally first_, later_, errors_;
};

std::size_t Judge::chosen(const MeasuredView& view, const CostCorrection& correction, const PlanGoal& goal) const {
  const Knobs knobs = plan({default_model(), machine_, view.features, correction}, goal).knobs;
  return static_cast<std::size_t>(std::find(candidates_.begin(), candidates_.end(), knobs) - candidates_.begin());
}

/// The correction that the dial has learnt after it drew the view with every row.
CostCorrection Judge::learnt(const MeasuredView& view) const {
  CostLog log;
  for (std::size_t i = 0; i < rows().size(); ++i)
    log.add(1, machine_.price * predicted_cost(default_model(), view.features, candidates_[i]), view.cost_ms[i]);
  return log.correction(1);
}

/// Tries budgets, and skips those that even the cheapest candidate exceeds: the dial could only answer with that one.
void Judge::budgets(const MeasuredView& view, const CostCorrection& correction, Tally& tally) const {
  for (double budget = 5; budget <= 2000; budget *= 1.26) {
    double best = 2;
    for (std::size_t i = 0; i < candidates_.size(); ++i)
      best = view.cost_ms[i] <= budget ? std::min(best, view.error[i]) : best;
    if (best > 1) continue;
    const std::size_t row = chosen(view, correction, {budget, {}});
    tally.add(view.cost_ms[row] <= budget_margin * budget, view.error[row] / best);
  }
}

/// Tries error limits, and skips those that no candidate meets.
void Judge::errors(const MeasuredView& view) {
  constexpr double never = 1e30;
  for (double max = 0.05; max <= 0.4; max *= 1.1) {
    double cheapest = never;
    for (std::size_t i = 0; i < candidates_.size(); ++i)
      cheapest = view.error[i] <= max ? std::min(cheapest, view.cost_ms[i]) : cheapest;
    if (cheapest == never) continue;
    const std::size_t row = chosen(view, {}, {{}, max});
    errors_.add(view.error[row] <= max, view.cost_ms[row] / cheapest);
  }
}

void Judge::judge(const MeasuredView& view) {
  const CostCorrection correction = learnt(view);
  fmt::print("  costs are {:.2f} times what is predicted\n", correction.factor);
  budgets(view, {}, first_), budgets(view, correction, later_), errors(view);
}

void Judge::print() {
  first_.print("budgets, first frames", "FLIP over the best");
  later_.print("budgets, later frames", "FLIP over the best");
  errors_.print("errors", "cost over the cheapest");
}

void judge(Renderer& renderer, const std::string& folder, int size, const Measuring& how, const Calibration& machine) {
  Judge judge(machine);
  const std::pair<const char*, FirstGroom> models[] = {{"spot.ply", {.length = 0.03}},
                                                       {"cat_ascii.ply", {.length = 0.02}},
                                                       {"koala.ply", {.length = 0.03}},
                                                       {"penguin.obj", {.length = 0.015}},
                                                       {"goathead.obj", {.length = 0.05}}};
  for (const auto& [file, fur] : models) {
    const testing::FurredModel model = testing::furred_file(folder + "/" + file, fur);
    sync_scene(renderer, model.view(), {});
    for (const CalibrationScene::View& view : {CalibrationScene::View{AutoView::three_quarter, 1, size},
                                               {AutoView::back, 1.5f, size / 2},
                                               {AutoView::left, 0.6f, size}}) {
      fmt::print("{}\n", file);
      judge.judge(measure_view(renderer, model.view(), measured_frame(model.view(), view), candidates(), how));
    }
    renderer.forget(model.model.id);
  }
  judge.print();
}

int main(int count, char** arguments) {
  const std::string mode = count > 2 ? arguments[1] : "";
  if (mode != "fit" && mode != "judge") return std::fprintf(stderr, "usage: bench_dial fit FILE | judge FOLDER\n"), 2;
  const auto number = [&](const char* name, int fallback) {
    return argument(count - 2, arguments + 2, name, fallback);
  };
  const Measuring how{number("--repetitions", 4), number("--threads", 0), number("--passes", 64)};
  const BenchRenderer opened = open_renderer(GlChoice::none, {.threads = std::max(how.threads, 1)});
  if (!opened.renderer) return 4;
  if (mode == "fit") {
    fit_defaults(*opened.renderer, arguments[2], static_cast<std::size_t>(number("--scenes", 100)), how);
    return 0;
  }
  Calibration machine;
  if (how.threads > 0) machine.price = value_or_end(measure_cost_ratio(*opened.renderer));
  judge(*opened.renderer, arguments[2], number("--size", 384), how, machine);
  return 0;
}

}  // namespace
}  // namespace pelage::bench

int main(int count, char** arguments) { return pelage::bench::main(count, arguments); }
