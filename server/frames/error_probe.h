// How far knobs are from the truth in a view, measured without drawing the truth of all of it.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <utility>
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

/// None where neither shows anything, and once `go_on` is false.
std::optional<FurError> fur_error(const Image& truth, const Image& test, const std::function<bool()>& go_on = {});

/// Shells of the truth that an error is judged by: their own error is a small part of it.
int truth_shells(double max_error);

/// Sorted shells that are nearer to the truth than the knobs, cheap enough for the whole view. Never as many as the
/// knobs have: the same shells are off in the same places.
Knobs nearer_knobs(const Knobs& knobs);

/// Draws windows of a view (renderer/quality/windows) as the truth, once, and with knobs; and the whole of it with the
/// knobs and with nearer ones. How much further the whole is from the nearer ones than its windows are says how much
/// further it is from the truth (a ratio estimator: Cochran, Sampling Techniques, 1977, 6). For the thread that draws;
/// the renderer has the frame's scene as long as it lives.
class ErrorProbe {
 public:
  /// About `places` of the frame's picture (ViewFeatures::places), against so many sorted shells.
  /// `pause` is called between the pieces of what is drawn, and while pictures are compared on a thread of their own;
  /// once it gives up, nothing more can be measured.
  ErrorProbe(Renderer& renderer, const FurFrame& frame, std::span<const glm::vec2> places, int truth_shells,
             Pause pause = {});

  /// Mean FLIP over the fur of the view; none where its windows show none or cannot be drawn.
  std::optional<double> error(const Knobs& knobs);

 private:
  using Pictures = std::vector<Image>;  // of views_, or of the windows among them

  /// Over the fur of all pictures; none where none shows any.
  std::optional<double> mean_error(std::span<const Image> truths, std::span<const Image> tests) const;
  std::optional<Pictures> draw(std::span<const FurFrame> views, const Knobs& knobs);
  /// The error of the whole over that of its windows, estimated by knobs that are nearer; 1 where it cannot be told.
  double whole_over_windows(const Knobs& knobs, std::span<const Image> pictures);

  Renderer& renderer_;
  Knobs truth_;
  Pause pause_;
  std::vector<FurFrame> views_;                     // the whole, and its windows
  Pictures truths_;                                 // of the windows, drawn when first asked for
  std::vector<std::pair<Knobs, Pictures>> nearer_;  // of all views
};

}  // namespace pelage
