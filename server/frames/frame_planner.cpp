#include "server/frames/frame_planner.h"

#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string_view>

#include "protocol/json/calibration.h"

namespace pelage {

extern const std::string_view default_calibration_json;  // made from defaults.json by the build

const Calibration& default_calibration() {
  static const Calibration calibration = [] {
    Result<Calibration> decoded = decode_calibration(default_calibration_json);
    assert(decoded);
    return std::move(decoded).value();
  }();
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
  const std::string temporary = path + "." + std::to_string(getpid());
  std::ofstream file(temporary, std::ios::binary);
  file << encode(calibration) << std::flush;
  if (file && std::rename(temporary.c_str(), path.c_str()) == 0) return {};
  std::remove(temporary.c_str());
  return failure(Code::internal, "Cannot write " + path + ".");
}

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
