#include "server/frames/frame_planner.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "base/temporary_name.h"
#include "protocol/json/calibration.h"
#include "renderer/quality/planner.h"

namespace pelage {

namespace {

/// Between 1, the slow machine that the model's prices are of, and half of that, which faster ones take.
constexpr double usual_price = 0.7;

}  // namespace

Calibration default_calibration(int threads) {
  Calibration calibration;
  calibration.price = usual_price / std::max(1, threads);
  return calibration;
}

Result<Calibration> read_calibration(const std::string& path, const std::string& machine, int threads) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return failure(Code::not_found, "There is no calibration " + path + ".");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  Result<Calibration> calibration = decode_calibration(text);
  if (!calibration) {
    const Status& status = calibration.status();
    return failure(Code::invalid, path + " is no calibration of this version: " + status.message, status.pointer,
                   status.limit);
  }
  if (calibration->machine != machine || calibration->threads != threads) {
    return failure(Code::invalid, path + " was measured with " + std::to_string(calibration->threads) + " threads of " +
                                      calibration->machine + ".");
  }
  return calibration;
}

Status write_calibration(const std::string& path, const Calibration& calibration) {
  const std::string temporary = temporary_beside(path);
  std::ofstream file(temporary, std::ios::binary);
  file << encode(calibration) << std::flush;
  if (file && std::rename(temporary.c_str(), path.c_str()) == 0) return {};
  std::remove(temporary.c_str());
  return failure(Code::internal, "Cannot write " + path + ".");
}

void FramePlanner::use(Calibration calibration) {
  const std::lock_guard lock(mutex_);
  next_ = std::move(calibration);
}

std::optional<FrameEstimate> FramePlanner::plan(const FrameRequest& request, const ViewFeatures& view,
                                                FurFrame& frame) {
  {
    const std::lock_guard lock(mutex_);
    if (next_) calibration_ = std::move(*next_), costs_ = CostLog(), next_.reset();
  }
  const PlanBasis basis{default_model(), calibration_, view, costs_.correction(frame.model)};
  if (!request.plans()) return estimate_of(basis, frame.knobs);
  const PlannedFrame planned = pelage::plan(basis, {request.budget_ms, request.max_error});
  frame.knobs = planned.knobs;
  return planned.estimate;
}

FrameCost FramePlanner::cost_of(const ViewFeatures& view, const FurFrame& frame) const {
  const CostCorrection correction = costs_.correction(frame.model);
  const DialModel& model = default_model();
  const double ms = predicted_cost(model, view, frame.knobs) * calibration_.price * correction.factor;
  return {ms / 1e3, correction.learnt ? model.learnt_safety : model.cost_safety};
}

void FramePlanner::learn(const FrameRequest& request, const FurFrame& frame, const FrameEstimate& estimate,
                         double cost_ms) {
  if (is_linear(request.format) || request.overlay != Overlay::none) return;
  costs_.add(frame.model, estimate.cost_ms / estimate.correction, cost_ms);
}

}  // namespace pelage
