#include "server/frames/frame_planner.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "base/temporary_name.h"
#include "protocol/json/calibration.h"
#include "renderer/quality/planner.h"
#include "renderer/quality/view_features.h"
#include "server/frames/fur_view.h"

namespace pelage {

namespace {

/// Price per thread, relative to the slow machine that the cost model was fitted on (1); fast machines take half of
/// that.
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

void FramePlanner::set_calibration(Calibration calibration) {
  const std::lock_guard lock(mutex_);
  calibration_ = std::move(calibration), costs_ = CostLog();
}

FramePlan FramePlanner::plan(const FrameRequest& request, const SceneView& scene) const {
  const FurFrame frame = make_frame(scene, request);
  const ViewFeatures features = view_features(frame, furred_skin(scene));
  std::unique_lock lock(mutex_);
  const Calibration machine = calibration_;
  const PlanBasis basis{default_model(), machine, features, costs_.correction(frame.model)};
  lock.unlock();
  FramePlan plan{.knobs = request.knobs};
  if (request.plans()) {
    const PlannedFrame planned = pelage::plan(basis, {request.budget_ms, request.max_error});
    plan.knobs = planned.knobs, plan.estimate = planned.estimate;
  } else {
    plan.estimate = estimate_of(basis, plan.knobs);
  }
  const double ms = predicted_cost(basis.model, features, plan.knobs) * machine.price;
  plan.cost = {.seconds = ms * basis.correction.factor / 1e3 * request.drawn_share(),
               .safety = basis.correction.learnt ? basis.model.learnt_safety : basis.model.cost_safety};
  return plan;
}

void FramePlanner::record_cost(const FrameRequest& request, const FurFrame& frame, const FrameEstimate& estimate,
                               double cost_ms) {
  if (is_linear(request.format) || request.overlay != Overlay::none) return;
  const std::lock_guard lock(mutex_);
  costs_.add(frame.model, estimate.cost_ms / estimate.correction, cost_ms);
}

}  // namespace pelage
