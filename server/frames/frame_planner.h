// The stored calibration, and the dial that plans frames by it.
#pragma once

#include <mutex>
#include <optional>
#include <string>

#include "base/status.h"
#include "protocol/commands/frame.h"
#include "protocol/commands/quality.h"
#include "renderer/quality/cost_log.h"
#include "renderer/quality/view_features.h"

namespace pelage {

/// Returns the calibration to assume for a machine that was never measured, on which `threads` threads share the work.
Calibration default_calibration(int threads);

/// Reads a file that write_calibration wrote. Fails with not_found if there is no file, and with invalid, saying what
/// is wrong, if the file cannot be read as a calibration or was measured with another GL or another number of threads.
Result<Calibration> read_calibration(const std::string& path, const std::string& machine, int threads);

/// Writes the file and renames it into place, so that readers never see half of it. Fails with internal.
Status write_calibration(const std::string& path, const Calibration& calibration);

/// The dial of a server: the price of its machine, and what its scenes' frames have cost. All but `use` belongs to the
/// thread that draws.
class FramePlanner {
 public:
  /// From any thread; counts from the next frame on.
  void use(Calibration calibration);

  /// Gives the frame its knobs where the request asks for a budget or an error. The estimate of the frame; none where
  /// the request names knobs that are no row.
  std::optional<FrameEstimate> plan(const FrameRequest& request, const ViewFeatures& view, FurFrame& frame);
  /// Estimates the cost of drawing a planned frame with its knobs.
  FrameCost cost_of(const ViewFeatures& view, const FurFrame& frame) const;
  /// Learns from the measured cost of a frame. Ignores frames with a linear format or an overlay.
  void learn(const FrameRequest& request, const FurFrame& frame, const FrameEstimate& estimate, double cost_ms);

 private:
  std::mutex mutex_;
  std::optional<Calibration> next_;
  Calibration calibration_;
  CostLog costs_;
};

}  // namespace pelage
