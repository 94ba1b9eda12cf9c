#include "server/frames/frame_planner.h"

#include <algorithm>

#include "server/frames/stored_calibration.h"

namespace pelage {

FramePlanner::FramePlanner() : calibration_(default_calibration()) {}

void FramePlanner::use(Calibration calibration) {
  const std::lock_guard lock(mutex_);
  next_ = std::move(calibration);
}

bool FramePlanner::looks_at(const FrameRequest& request) {
  {
    const std::lock_guard lock(mutex_);
    if (next_) calibration_ = std::move(*next_), costs_ = CostLog(), errors_ = ErrorLog(), next_.reset();
  }
  const auto& ladder = calibration_.ladder;
  return request.plans() ||
         std::any_of(ladder.begin(), ladder.end(), [&](const auto& row) { return row.knobs == request.knobs; });
}

std::optional<FrameEstimate> FramePlanner::plan(const FrameRequest& request, const ViewFeatures& view, FurFrame& frame,
                                                const MeasureError& measure) {
  const CostCorrection correction = costs_.correction(frame.model);
  if (!request.plans()) return estimate_of(calibration_, view, frame.knobs, correction);
  const PlannedFrame planned =
      request.max_error ? plan_measured(calibration_, view, frame, correction, *request.max_error,
                                        errors_.of(frame, in_range(calibration_, error_traits_of(view))), measure)
                        : pelage::plan(calibration_, view, frame, correction, {request.budget_ms, {}});
  frame.knobs = planned.knobs;
  return planned.estimate;
}

void FramePlanner::learn(const FrameRequest& request, const FurFrame& frame, const FrameEstimate& estimate,
                         double cost_ms) {
  if (request.format == FrameFormat::exr || request.overlay != Overlay::none) return;
  costs_.add(frame.model, frame.knobs, estimate.cost_ms / estimate.correction, cost_ms);
}

}  // namespace pelage
