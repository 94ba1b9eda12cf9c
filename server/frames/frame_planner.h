// The stored calibration, and the dial that plans frames by it.
#pragma once

#include <mutex>
#include <optional>
#include <string>

#include "protocol/base/status.h"
#include "protocol/commands/frame.h"
#include "protocol/commands/quality.h"
#include "renderer/quality/cost_log.h"
#include "renderer/quality/view_features.h"

namespace pelage {

/// What is known of a machine that was never measured: so many threads share the work.
Calibration default_calibration(int threads);

/// Reads a file that write_calibration has written. Fails with not_found where there is none, and (invalid) with what
/// is wrong with it: not readable as a calibration, or measured with another GL or another number of threads.
Result<Calibration> read_calibration(const std::string& path, const std::string& machine, int threads);

/// By rename, so that readers see no half of it. Fails with internal.
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
  /// What drawing a frame with its knobs is expected to take, once it was planned.
  FrameCost cost_of(const ViewFeatures& view, const FurFrame& frame) const;
  /// What the frame has cost. Frames that draw more than shells in light are not counted.
  void learn(const FrameRequest& request, const FurFrame& frame, const FrameEstimate& estimate, double cost_ms);

 private:
  std::mutex mutex_;
  std::optional<Calibration> next_;
  Calibration calibration_;
  CostLog costs_;
};

}  // namespace pelage
