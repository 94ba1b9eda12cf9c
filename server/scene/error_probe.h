// How far knobs are from the truth in a view, measured on parts of it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "renderer/frame/renderer.h"

namespace pelage {

/// What a frame is compared with: so many sorted shells, in the light that the dial's frames have.
Knobs reference_knobs(int shells);

/// FLIP over the fur of either picture: the mean, and how many pixels that is.
struct FurError {
  double mean = 0;
  double pixels = 0;
};

/// None where neither shows anything.
std::optional<FurError> fur_error(const Image& truth, const Image& test);

/// Shells of the truth that an error is judged by: their own error is a small part of it.
int truth_shells(double max_error);

/// Draws windows of a view (renderer/quality/windows) as the truth, once, and with knobs. For the thread that draws; the
/// renderer has the frame's scene as long as it lives.
class ErrorProbe {
 public:
  /// About `places` of the frame's picture (ViewFeatures::places), against so many sorted shells.
  ErrorProbe(Renderer& renderer, const FurFrame& frame, std::span<const glm::vec2> places, int truth_shells);

  /// Mean FLIP over the fur of all windows; none where they show none or cannot be drawn.
  std::optional<double> error(const Knobs& knobs);

 private:
  std::optional<Image> draw(FurFrame window, const Knobs& knobs);

  Renderer& renderer_;
  int truth_shells_;
  std::vector<FurFrame> windows_;
  std::vector<Image> truths_;  // of each window, drawn when first asked for
};

}  // namespace pelage
