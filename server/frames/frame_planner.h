// Stores the calibration, and plans the knobs of frames with it.
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

/// Returns the default calibration for a machine that was never measured, on which `threads` threads share the work.
Calibration default_calibration(int threads);

/// Reads a file that write_calibration wrote. Fails with not_found if there is no file, and with invalid, with the
/// reason, if the file is not a calibration or was measured with another GL or number of threads.
Result<Calibration> read_calibration(const std::string& path, const std::string& machine, int threads);

/// Writes a temporary file and renames it into place, so that readers never see a partial file. Fails with internal.
Status write_calibration(const std::string& path, const Calibration& calibration);

/// Plans frames by the machine's calibration and the measured costs of earlier frames of each scene. Thread-safe.
class FramePlanner {
 public:
  /// Sets the calibration, from the next frame on, and drops the measured costs.
  void set_calibration(Calibration calibration);

  /// Chooses the knobs if the request asks for a budget or an error, and estimates their error and cost.
  FramePlan plan(const FrameRequest& request, const SceneView& scene) const;
  /// Learns from the measured cost of a frame with an estimate. Ignores frames with a linear format or an overlay.
  void record_cost(const FrameRequest& request, const FurFrame& frame, const FrameEstimate& estimate, double cost_ms);

 private:
  mutable std::mutex mutex_;  // held only briefly
  Calibration calibration_;
  CostLog costs_;
};

}  // namespace pelage
