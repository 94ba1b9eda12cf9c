#include "server/frames/error_probe.h"

#include <algorithm>

#include "renderer/compare/compare.h"
#include "renderer/compare/flip.h"
#include "renderer/frame/run_beside.h"
#include "renderer/quality/planner.h"
#include "renderer/quality/view_features.h"

namespace pelage {

namespace {

constexpr double min_error = 1e-5;  // of pictures that are the same
constexpr double max_ratio = 4;     // of the whole's error to that of its windows: fur that they missed

/// Over the fur of all pictures.
std::optional<double> mean_of(std::span<const Image> truths, std::span<const Image> tests,
                              const std::function<bool()>& go_on) {
  double sum = 0, pixels = 0;
  for (std::size_t i = 0; i < truths.size(); ++i) {
    const std::optional<FurError> error = fur_error(truths[i], tests[i], go_on);  // none of a window beside the fur
    if (error) sum += error->mean * error->pixels, pixels += error->pixels;
  }
  if (pixels == 0) return {};
  return sum / pixels;
}

}  // namespace

Knobs reference_knobs(int shells) {
  Knobs knobs = knobs_of(Tier::interactive);
  knobs.shells = shells, knobs.shell_policy = ShellPolicy::uniform, knobs.order = FragmentOrder::sorted;
  return knobs;
}

std::optional<FurError> fur_error(const Image& truth, const Image& test, const std::function<bool()>& go_on) {
  const FloatImage reference = linear_image(truth), other = linear_image(test);
  const Mask mask = union_of(alpha_mask(reference), alpha_mask(other));
  const auto pixels = static_cast<double>(mask.count());
  if (pixels == 0) return {};
  const CompareOptions options;
  const std::vector<float> errors =
      flip_map(as_displayed(reference, options), as_displayed(other, options), options.pixels_per_degree, 0, go_on);
  double sum = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) sum += mask.inside[i] ? errors[i] : 0.0f;
  if (errors.empty()) return {};
  return FurError{sum / pixels, pixels};
}

int truth_shells(double max_error) { return max_error < 0.02 ? 256 : 128; }

Knobs nearer_knobs(const Knobs& knobs) {
  if (knobs.shells <= 8) return reference_knobs(16);
  if (knobs.shells < 32) return reference_knobs(32);
  return reference_knobs(knobs.shells == 48 ? 64 : 48);
}

ErrorProbe::ErrorProbe(Renderer& renderer, const FurFrame& frame, std::span<const glm::vec2> places, int truth_shells,
                       Pause pause)
    : renderer_(renderer), truth_(reference_knobs(truth_shells)), pause_(std::move(pause)), views_{fur_alone(frame)} {
  const int side = window_side(frame.width, frame.height);
  for (const glm::vec2& place : places) views_.push_back(window_of(frame, place, side));
}

std::optional<double> ErrorProbe::mean_error(std::span<const Image> truths, std::span<const Image> tests) const {
  if (!pause_) return mean_of(truths, tests, {});
  const auto error = run_beside(pause_, [&](const auto& go_on) { return mean_of(truths, tests, go_on); });
  return error ? *error : std::nullopt;
}

std::optional<ErrorProbe::Pictures> ErrorProbe::draw(std::span<const FurFrame> views, const Knobs& knobs) {
  Pictures pictures;
  for (FurFrame view : views) {
    if (pause_ && !pause_()) return {};
    view.knobs = knobs;
    Result<Image> image = renderer_.draw(view, nullptr, pause_);
    if (!image) return {};
    pictures.push_back(std::move(image).value());
  }
  return pictures;
}

double ErrorProbe::whole_over_windows(const Knobs& knobs, std::span<const Image> pictures) {
  const Knobs nearer = nearer_knobs(knobs);
  if (!fits(nearer, views_[0].width, views_[0].height)) return 1;
  auto drawn = std::find_if(nearer_.begin(), nearer_.end(), [&](const auto& one) {
    return one.first.shells >= nearer.shells && one.first.shells != knobs.shells;
  });
  if (drawn == nearer_.end()) {
    std::optional<Pictures> all = draw(views_, nearer);
    if (!all) return 1;
    drawn = nearer_.insert(drawn, {nearer, std::move(*all)});
  }
  const std::span<const Image> others(drawn->second);
  const std::optional<double> whole = mean_error(others.first(1), pictures.first(1));
  const std::optional<double> windows = mean_error(others.subspan(1), pictures.subspan(1));
  return whole && windows && *windows > 0 ? std::clamp(*whole / *windows, 1 / max_ratio, max_ratio) : 1;
}

std::optional<double> ErrorProbe::error(const Knobs& knobs) {
  const std::span<const FurFrame> windows = std::span(views_).subspan(1);
  if (truths_.size() < windows.size()) {
    std::optional<Pictures> truths = draw(windows, truth_);
    if (!truths) return {};
    truths_ = std::move(*truths);
  }
  const std::optional<Pictures> pictures = draw(views_, knobs);
  if (!pictures) return {};
  const std::optional<double> error = mean_error(truths_, std::span(*pictures).subspan(1));
  if (!error) return {};
  return std::max(*error * whole_over_windows(knobs, *pictures), min_error);
}

}  // namespace pelage
