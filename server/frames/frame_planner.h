// The dial of a server: its calibration, and what its scenes' frames have cost.
#pragma once

#include <mutex>
#include <optional>

#include "protocol/commands/frame.h"
#include "protocol/commands/quality.h"
#include "renderer/quality/cost_log.h"
#include "renderer/quality/error_log.h"

namespace pelage {

/// All but `use` belongs to the thread that draws.
class FramePlanner {
 public:
  FramePlanner();  // plans by the safe defaults

  /// From any thread; counts from the next frame on.
  void use(Calibration calibration);

  /// Whether the request's frame is planned or can be estimated, and its view has to be looked at.
  bool looks_at(const FrameRequest& request);
  /// Gives the frame its knobs where the request asks for a budget or an error. The estimate of the frame. Where an
  /// error is asked for, `measure` is called for what is not known of the scene as it is seen.
  std::optional<FrameEstimate> plan(const FrameRequest& request, const ViewFeatures& view, FurFrame& frame,
                                    const MeasureError& measure);
  /// What the frame has cost. Frames that draw more than shells in light are not counted.
  void learn(const FrameRequest& request, const FurFrame& frame, const FrameEstimate& estimate, double cost_ms);

 private:
  std::mutex mutex_;
  std::optional<Calibration> next_;
  Calibration calibration_;
  CostLog costs_;
  ErrorLog errors_;
};

}  // namespace pelage
