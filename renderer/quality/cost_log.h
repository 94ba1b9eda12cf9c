// What frames of a scene have cost, so that the next ones are planned by it.
#pragma once

#include <cstdint>
#include <deque>
#include <map>

namespace pelage {

/// The measured cost of a scene over what its views predict.
struct CostCorrection {
  double factor = 1;
  bool learnt = false;  // from enough frames
  bool operator==(const CostCorrection&) const = default;
};

/// Keeps the corrections of the scenes that were drawn last. Corrections move in steps, and only where the median of
/// the last frames is off by more than `slack`, so that equal requests get equal knobs.
class CostLog {
 public:
  static constexpr std::size_t max_scenes = 256;
  static constexpr std::size_t window_frames = 7;  // of a scene
  static constexpr std::size_t min_frames = 3;     // before a correction changes: the first ones bake and build
  static constexpr double slack = 1.08;            // factor, in either direction
  static constexpr double step = 1.04;             // corrections are powers of it
  static constexpr double max = 32;                // corrections lie in [1 / max, max]

  CostCorrection correction(std::uint64_t scene) const;
  /// `predicted` is without a correction; both in ms. Costs that are not above 0 and finite are not counted.
  void add(std::uint64_t scene, double predicted, double measured);

 private:
  struct Scene {
    std::deque<double> ratios;  // newest last
    double correction = 1;
    std::uint64_t used = 0;
  };

  std::map<std::uint64_t, Scene> scenes_;
  std::uint64_t clock_ = 0;
};

}  // namespace pelage
