// The stored calibration, and the dial that plans frames by it.
#pragma once

#include <mutex>
#include <optional>
#include <string>

#include "base/status.h"
#include "protocol/commands/frame.h"
#include "protocol/commands/quality.h"
#include "renderer/quality/cost_log.h"
#include "server/frames/frame_order.h"

namespace pelage {

/// Returns the calibration to assume for a machine that was never measured, on which `threads` threads share the work.
Calibration default_calibration(int threads);

/// Reads a file that write_calibration wrote. Fails with not_found if there is no file, and with invalid, saying what
/// is wrong, if the file cannot be read as a calibration or was measured with another GL or another number of threads.
Result<Calibration> read_calibration(const std::string& path, const std::string& machine, int threads);

/// Writes the file and renames it into place, so that readers never see half of it. Fails with internal.
Status write_calibration(const std::string& path, const Calibration& calibration);

/// The dial of a server: the price of its machine, and what its scenes' frames have cost. Thread-safe.
class FramePlanner {
 public:
  /// Counts from the next frame on.
  void use(Calibration calibration);

  /// Chooses the knobs where the request asks for a budget or an error, and estimates what they give and cost.
  FramePlan plan(const FrameRequest& request, const SceneView& scene) const;
  /// Learns from the measured cost of a frame with an estimate. Ignores frames with a linear format or an overlay.
  void learn(const FrameRequest& request, const FurFrame& frame, const FrameEstimate& estimate, double cost_ms);

 private:
  mutable std::mutex mutex_;  // held for a look-up only
  Calibration calibration_;
  CostLog costs_;
};

}  // namespace pelage
