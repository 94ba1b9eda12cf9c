#include "server/scene/error_probe.h"

#include <algorithm>

#include "renderer/compare/compare.h"
#include "renderer/quality/windows.h"

namespace pelage {

namespace {

constexpr double least_error = 1e-5;  // of pictures that are the same

}  // namespace

Knobs reference_knobs(int shells) {
  Knobs knobs = knobs_of(Tier::interactive);
  knobs.shells = shells, knobs.shell_policy = ShellPolicy::uniform, knobs.order = FragmentOrder::sorted;
  knobs.accumulation = Accumulation::full;
  return knobs;
}

std::optional<FurError> fur_error(const Image& truth, const Image& test) {
  const Mask mask = union_of(alpha_mask(linear_image(truth)), alpha_mask(linear_image(test)));
  const Result<PictureError> error = compare(truth, test, mask);
  if (!error || !error->figures) return {};
  return FurError{error->figures->flip.mean, static_cast<double>(error->pixels)};
}

int truth_shells(double max_error) { return max_error < 0.02 ? 256 : 128; }

ErrorProbe::ErrorProbe(Renderer& renderer, const FurFrame& frame, std::span<const glm::vec2> places, int truth_shells)
    : renderer_(renderer), truth_shells_(truth_shells) {
  const int side = window_side(frame.width, frame.height);
  for (const glm::vec2& place : places) windows_.push_back(window_of(frame, place, side));
}

std::optional<Image> ErrorProbe::draw(FurFrame window, const Knobs& knobs) {
  window.knobs = knobs;
  Result<Image> image = renderer_.draw(window);
  if (!image) return {};
  return std::move(image).value();
}

std::optional<double> ErrorProbe::error(const Knobs& knobs) {
  while (truths_.size() < windows_.size()) {
    std::optional<Image> truth = draw(windows_[truths_.size()], reference_knobs(truth_shells_));
    if (!truth) return {};
    truths_.push_back(std::move(*truth));
  }
  double sum = 0, pixels = 0;
  for (std::size_t i = 0; i < windows_.size(); ++i) {
    const std::optional<Image> image = draw(windows_[i], knobs);
    if (!image) return {};
    const std::optional<FurError> error = fur_error(truths_[i], *image);  // none of a window beside the fur
    if (error) sum += error->mean * error->pixels, pixels += error->pixels;
  }
  if (pixels == 0) return {};
  return std::max(sum / pixels, least_error);
}

}  // namespace pelage
