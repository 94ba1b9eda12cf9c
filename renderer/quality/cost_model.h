// What a frame of shells costs: a sum of what is counted in it, each at a price of its own that calibration finds.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>

#include "protocol/commands/quality.h"
#include "renderer/quality/planner.h"
#include "renderer/quality/view_features.h"

namespace pelage {

/// Units of each term: a million pixels or fragments, a hundred thousand triangles of shells.
std::array<double, cost_terms> cost_terms_of(const ViewFeatures& view, const Knobs& knobs);

/// Milliseconds of drawing (FrameEstimate), above 0, without what eyes, curves and shadow maps add.
double predicted_cost(const Calibration& calibration, const ViewFeatures& view, const Knobs& knobs);

// What frames of a scene have cost, so that the next ones are planned by it.

/// Keeps the corrections of the scenes that were drawn last. Corrections move in steps, and only where the median of
/// the last frames is off by more than `slack`, so that equal requests get equal knobs.
class CostLog {
 public:
  static constexpr std::size_t max_scenes = 256;
  static constexpr std::size_t window_frames = 7;  // of a scene and order
  static constexpr std::size_t min_frames = 3;     // before a correction changes: the first ones build programs
  static constexpr double slack = 1.08;            // times or over
  static constexpr double step = 1.04;             // corrections are powers of it
  static constexpr double max = 32;                // corrections lie in [1 / most, most]

  CostCorrection correction(std::uint64_t scene) const;
  /// `predicted` is without a correction; both in ms. Costs that are not above 0 and finite are not counted.
  void add(std::uint64_t scene, const Knobs& knobs, double predicted, double measured);
  void forget(std::uint64_t scene) { scenes_.erase(scene); }

 private:
  struct Record {
    std::deque<double> ratios;  // newest last
    double correction = 1;

    void add(double ratio);
    bool learnt() const { return ratios.size() >= min_frames; }
  };
  struct Scene {
    Record shells, sorted;
    std::uint64_t used = 0;
  };

  std::map<std::uint64_t, Scene> scenes_;
  std::uint64_t clock_ = 0;
};

}  // namespace pelage
