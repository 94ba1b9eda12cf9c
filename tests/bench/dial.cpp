// The dial: fits the defaults on built-in models, and judges them on models that the fit does not know.
// usage: bench_dial fit FILE [--truth SHELLS] [--scenes N]
//          draws the calibration's scenes with all candidates and writes the calibration (server/frames/defaults.json)
//        bench_dial judge FOLDER [--truth SHELLS] [--size PIXELS] [--views N] [--models N] [--own-costs 1]
//          draws the models of a folder (spot.ply, cat_ascii.ply, koala.ply) with all candidates, and says how often
//          budgets and errors are kept and how far the choices are from the best ones. The prices are the defaults', or
//          with --own-costs measured first, as `pelage calibrate` does.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

#include "protocol/json/calibration.h"
#include "renderer/quality/cost_model.h"
#include "renderer/quality/error_model.h"
#include "server/calibration/calibrate.h"
#include "server/frames/frame_planner.h"
#include "server/frames/fur_view.h"
#include "tests/bench/measure.h"

namespace pelage::bench {
namespace {

void print_row(const Knobs& k, double cost, double error, const char* mark = "") {
  std::printf("  %3d x %d, scale %.2f, %s: %8.2f ms, FLIP %.4f %s\n", k.shells, k.steps, k.scale,
              k.shell_policy == ShellPolicy::uniform ? "uniform" : "adaptive", cost, error, mark);
}

/// The columns of the rows that are kept.
std::vector<double> picked(const std::vector<double>& all, const std::vector<std::size_t>& rows) {
  std::vector<double> result;
  for (const std::size_t row : rows) result.push_back(all[row]);
  return result;
}

void print_view(const char* name, const MeasuredView& view, std::span<const Knobs> ladder) {
  const ViewFeatures& f = view.features;
  std::printf(
      "%s: pixels %.0f triangles %.0f visible %.0f area %.0f edges %.0f covered %.0f behind %.3f fur %.2f strand %.3f "
      "bending %.3f lightness %.3f lights %.0f scatters %d varies %d\n",
      name, f.pixels, f.triangles, f.visible, f.area, f.edges, f.covered, f.behind, f.fur_pixels, f.strand_pixels,
      f.bending, f.lightness, f.lights, f.scatters, f.varies);
  for (std::size_t row = 0; row < ladder.size(); ++row) {
    const std::string probed = view.probed_error[row] > 0 ? "probed " + std::to_string(view.probed_error[row]) : "";
    print_row(ladder[row], view.cost_ms[row], view.error[row], probed.c_str());
  }
  std::fflush(stdout);
}

std::vector<MeasuredView> measure_all(Renderer& renderer, std::span<const Knobs> ladder, const MeasureOptions& options,
                                      int max_scenes) {
  std::vector<MeasuredView> views;
  std::uint64_t id = 0;
  for (const CalibrationScene& described : calibration_scenes()) {
    if (static_cast<int>(id) >= max_scenes) break;
    const MeasuredScene scene = make_measured_scene(described, ++id);
    sync_scene(renderer, scene.view(), {});
    for (const CalibrationScene::View& view : described.views) {
      Result<MeasuredView> measured =
          measure_view(renderer, cost_unit(true, 0), scene.view(), measured_frame(scene.view(), view), ladder, options);
      if (!measured) std::printf("%s\n", measured.status().message.c_str()), std::exit(1);
      views.push_back(std::move(*measured));
      print_view(std::to_string(views.size()).c_str(), views.back(), ladder);
    }
    renderer.forget(scene.model.id);
  }
  return views;
}

/// Geometric means over the views: what the ladder looks like.
void print_ladder(const Calibration& calibration, const std::vector<MeasuredView>& views) {
  for (std::size_t row = 0; row < calibration.ladder.size(); ++row) {
    double cost = 0, error = 0;
    for (const MeasuredView& view : views) cost += std::log(view.cost_ms[row]), error += std::log(view.error[row]);
    const double count = static_cast<double>(views.size());
    const std::string mark = "error safety " + std::to_string(calibration.ladder[row].error_safety);
    print_row(calibration.ladder[row].knobs, std::exp(cost / count), std::exp(error / count), mark.c_str());
  }
}

int fit(Renderer& renderer, const std::string& file, const MeasureOptions& options, int scenes) {
  std::vector<Knobs> candidates = candidate_ladder(), ladder;
  std::vector<MeasuredView> views = measure_all(renderer, candidates, options, scenes);
  std::vector<std::size_t> rows = pareto_rows(views);
  if (rows.front() != 0) rows.insert(rows.begin(), 0);  // the tier has an estimate whether or not it is among the best
  for (const std::size_t row : rows) ladder.push_back(candidates[row]);
  for (MeasuredView& view : views) {
    for (std::vector<double>* column : {&view.cost_ms, &view.error, &view.probed_error})
      *column = picked(*column, rows);
  }
  Calibration calibration = fit_calibration(ladder, views);
  calibration.name = "defaults";
  print_ladder(calibration, views);
  std::printf(
      "%zu of %zu candidates; safety of cost %.2f, once learnt %.2f, of a probed error %.2f\nprices:", ladder.size(),
      candidates.size(), calibration.cost_safety, calibration.learnt_safety, calibration.probe_safety);
  for (const double price : calibration.cost) std::printf(" %.4g", price);
  std::printf("\n");
  std::ofstream(file) << encode(calibration);
  return 0;
}

/// What the dial promises, over all frames.
struct Tally {
  int frames = 0, kept = 0, near_best = 0;
  std::vector<double> ratios;  // to the best choice

  void add(bool keeps, double ratio, double bound) {
    ++frames, kept += keeps, near_best += ratio <= bound;
    ratios.push_back(ratio);
  }
  void print(const char* what, const char* ratio) {
    if (ratios.empty()) return;
    std::sort(ratios.begin(), ratios.end());
    std::printf("%s: %d frames, kept %.1f%%; %s median %.2f, 95%% %.2f, within bound %.1f%%\n", what, frames,
                100.0 * kept / frames, ratio, ratios[ratios.size() / 2], ratios[ratios.size() * 95 / 100],
                100.0 * near_best / frames);
  }
};

struct Judged {
  const Calibration& calibration;
  std::vector<Knobs> candidates;
  Tally first = {}, later = {}, told = {}, measured = {};
  int requests = 0, probes = 0;  // knob sets that were probed

  std::size_t index_of(const Knobs& knobs) const {
    return static_cast<std::size_t>(std::find(candidates.begin(), candidates.end(), knobs) - candidates.begin());
  }
  void budgets(const MeasuredView& view, const FurFrame& frame, const CostCorrection& correction, Tally& tally);
  void max_errors(const MeasuredView& view, const FurFrame& frame, const CostCorrection& correction, bool probing,
                  Tally& tally);
  CostCorrection learnt(const MeasuredView& view) const;
  void judge(const MeasuredView& view, const FurFrame& frame);
};

/// Budgets that the cheapest candidate keeps: others can only be answered with it.
void Judged::budgets(const MeasuredView& view, const FurFrame& frame, const CostCorrection& correction, Tally& tally) {
  for (double budget = 20; budget <= 2000; budget *= 1.26) {
    double best = 1e30;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (view.cost_ms[i] <= budget) best = std::min(best, view.error[i]);
    }
    if (best > 1) continue;
    const PlannedFrame planned = plan(calibration, view.features, frame, correction, {budget, {}});
    const std::size_t row = index_of(planned.knobs);
    tally.add(view.cost_ms[row] <= 1.25 * budget, view.error[row] / best, 1.25);
  }
}

/// By probes, as the first request of its scene; or estimated from its features alone.
void Judged::max_errors(const MeasuredView& view, const FurFrame& frame, const CostCorrection& correction, bool probing,
                        Tally& tally) {
  for (double max = 0.008; max <= 0.12; max *= 1.2) {
    double cheapest = 1e30;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (view.error[i] <= max) cheapest = std::min(cheapest, view.cost_ms[i]);
    }
    if (cheapest > 1e29) continue;
    MeasuredErrors errors;
    const MeasureError measure = [&](const Knobs& knobs) {
      return ++probes, std::optional(view.probed_error[index_of(knobs)]);
    };
    requests += probing;
    const PlannedFrame planned =
        probing ? plan_measured(calibration, view.features, frame, correction, max, errors, measure)
                : plan(calibration, view.features, frame, correction, {{}, max});
    const std::size_t row = index_of(planned.knobs);
    tally.add(view.error[row] <= max, view.cost_ms[row] / cheapest, 1.5);
  }
}

/// After a few frames of each order.
CostCorrection Judged::learnt(const MeasuredView& view) const {
  CostLog log;
  for (std::size_t i = 0; i < candidates.size(); i += 3)
    log.add(1, candidates[i], predicted_cost(calibration, view.features, candidates[i]), view.cost_ms[i]);
  return log.correction(1);
}

void Judged::judge(const MeasuredView& view, const FurFrame& frame) {
  double cost = 0, error = 0;
  for (const CalibratedKnobs& row : calibration.ladder) {
    const std::size_t i = index_of(row.knobs);
    const double predicted = predicted_error(row, in_range(calibration, error_traits_of(view.features)));
    cost += std::log(view.cost_ms[i] / predicted_cost(calibration, view.features, row.knobs));
    error += std::log(view.error[i] / predicted);
  }
  const double count = static_cast<double>(calibration.ladder.size());
  const CostCorrection correction = learnt(view);
  const ViewFeatures& f = view.features;
  std::printf("cost %.2f and FLIP %.2f times the estimate; learnt %.2f and %.2f; fur %.1f px, behind %.2f, area %.0f\n",
              std::exp(cost / count), std::exp(error / count), correction.shells, correction.sorted, f.fur_pixels,
              f.behind, f.area);
  std::fflush(stdout);
  budgets(view, frame, {}, first), budgets(view, frame, correction, later);
  max_errors(view, frame, correction, false, told), max_errors(view, frame, correction, true, measured);
}

struct JudgeOptions {
  int size, views, models;
};

int judge(Renderer& renderer, const std::string& folder, const MeasureOptions& options, const JudgeOptions& extent,
          const Calibration& calibration) {
  const int size = extent.size;
  Judged judged{calibration, candidate_ladder()};
  const CalibrationScene::View views[] = {
      {AutoView::three_quarter, 1, size}, {AutoView::back, 1.5f, size}, {AutoView::left, 0.6f, size}};
  const std::pair<const char*, FirstGroom> models[] = {
      {"spot.ply", {.length = 0.03}}, {"cat_ascii.ply", {.length = 0.02}}, {"koala.ply", {.length = 0.03}}};
  for (const auto& [file, fur] : std::span(models).first(static_cast<std::size_t>(std::clamp(extent.models, 1, 3)))) {
    const testing::FurredModel model = testing::furred_ply(folder + "/" + file, fur);
    sync_scene(renderer, model.view(), {});
    for (const CalibrationScene::View& view :
         std::span(views).first(static_cast<std::size_t>(std::clamp(extent.views, 1, 3)))) {
      const FurFrame frame = measured_frame(model.view(), view);
      const Result<MeasuredView> measured =
          measure_view(renderer, cost_unit(true, 0), model.view(), frame, judged.candidates, options);
      if (!measured) return std::printf("%s\n", measured.status().message.c_str()), 1;
      print_view(file, *measured, judged.candidates);
      judged.judge(*measured, frame);
    }
    renderer.forget(model.model.id);
  }
  judged.first.print("budgets, first frames", "FLIP over the best");
  judged.later.print("budgets, later frames", "FLIP over the best");
  judged.told.print("errors estimated from the view", "cost over the cheapest");
  judged.measured.print("errors probed", "cost over the cheapest");
  std::printf("%.1f knob sets were probed for a request\n", double(judged.probes) / std::max(judged.requests, 1));
  return 0;
}

int main(int count, char** arguments) {
  const std::string mode = count > 2 ? arguments[1] : "";
  if (mode != "fit" && mode != "judge") return std::fprintf(stderr, "usage: bench_dial fit FILE | judge FOLDER\n"), 2;
  const BenchRenderer opened = open_renderer(renderer_options(cost_unit(true, 0)));
  if (!opened.renderer) return 4;
  const auto number = [&](const char* name, int fallback) {
    return argument(count - 2, arguments + 2, name, fallback);
  };
  const MeasureOptions options{number("--truth", 256), number("--repetitions", 2), mode == "fit" ? 3 : 1};
  if (mode == "fit") return fit(*opened.renderer, arguments[2], options, number("--scenes", 100));
  Calibration calibration = default_calibration();
  if (number("--own-costs", 0)) {
    const Result<Calibration> own = calibrate(*opened.renderer, cost_unit(true, 0), calibration, [](double) {});
    if (!own) return 1;
    calibration = *own;
    std::printf("safety of cost %.2f\n", calibration.cost_safety);
  }
  const std::vector<Knobs> candidates = candidate_ladder();
  for (const CalibratedKnobs& row : calibration.ladder) {
    if (std::find(candidates.begin(), candidates.end(), row.knobs) != candidates.end()) continue;
    return std::fprintf(stderr, "the calibration has a row that is no candidate any more: run bench_dial fit\n"), 1;
  }
  return judge(*opened.renderer, arguments[2], options,
               {number("--size", 384), number("--views", 3), number("--models", 3)}, calibration);
}

}  // namespace
}  // namespace pelage::bench

int main(int count, char** arguments) { return pelage::bench::main(count, arguments); }
