// How far a frame of shells is from many sorted ones, as far as a view tells without being drawn. Each knob set of the
// ladder has a line of its own: the logarithm of the error over traits of the view.
#pragma once

#include <array>
#include <cstdint>
#include <map>

#include "protocol/commands/quality.h"
#include "renderer/quality/planner.h"
#include "renderer/quality/view_features.h"

namespace pelage {

/// Below this an error is not told apart from none.
inline constexpr double min_error = 1e-5;

using ErrorTraits = std::array<double, error_traits>;

/// Binary logarithms of the fur's length, the strands' width and the model's size in pixels; the share of fur behind
/// other fur; the skin's bending; the coat's lightness. Finite.
ErrorTraits error_traits_of(const ViewFeatures& view);

/// The traits from 0 to 1 over the range that was measured; what lies outside counts as its end.
ErrorTraits in_range(const Calibration& calibration, const ErrorTraits& traits);

/// Mean FLIP of an average frame like this (FrameEstimate), (0, 1].
double predicted_error(const CalibratedKnobs& row, const ErrorTraits& in_range);

// What errors of scenes were measured, so that the next frames of like views are planned by them.

/// Keeps the measured errors of the scenes that were asked for last, of one coat in one light seen from about as far:
/// of other views nothing is known. Equal requests in a row get equal knobs.
class ErrorLog {
 public:
  static constexpr std::size_t max_scenes = 256;
  static constexpr double slack = 0.15;  // of each trait, in [0, 1], up to which views are alike

  /// What is known of the frame's scene; nothing yet where it was never seen like this. Stays until the next call.
  MeasuredErrors& of(const FurFrame& frame, const ErrorTraits& in_range);

 private:
  struct Scene {
    ErrorTraits traits{};
    FurFrame frame;  // that was first seen like this
    MeasuredErrors errors;
    std::uint64_t used = 0;

    bool is_like(const FurFrame& other, const ErrorTraits& others) const;
  };

  std::map<std::uint64_t, Scene> scenes_;
  std::uint64_t clock_ = 0;
};

}  // namespace pelage
