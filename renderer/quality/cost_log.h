// Records the measured costs of a scene's frames, to correct predictions for the next ones.
#pragma once

#include <cstdint>
#include <deque>
#include <map>

namespace pelage {

/// The measured cost of a scene over the predicted one.
struct CostCorrection {
  double factor = 1;
  bool learnt = false;  // enough frames were measured
  bool operator==(const CostCorrection&) const = default;
};

/// The corrections of the scenes that were drawn last. Corrections move in steps, and only if the median of the last
/// frames is off by more than `slack`, so that equal requests get equal knobs.
class CostLog {
 public:
  static constexpr std::size_t max_scenes = 256;
  static constexpr std::size_t window_frames = 7;  // frames of a scene whose median counts
  static constexpr std::size_t min_frames = 3;     // before a correction changes; the first frames include baking
  static constexpr double slack = 1.08;            // factor, in either direction
  static constexpr double step = 1.04;             // corrections are powers of it
  static constexpr double max = 32;                // corrections lie in [1 / max, max]

  CostCorrection correction(std::uint64_t scene) const;
  /// Adds a frame. `predicted` is without a correction; both in ms. Ignored if their ratio is not finite and above 0.
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
