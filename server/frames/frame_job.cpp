#include "server/frames/frame_job.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace pelage {

Status check_seconds(const FrameRequest& request, const FrameCost& cost) {
  if (cost.seconds <= request.max_seconds) return {};
  return failure(Code::invalid,
                 "Drawing this frame is expected to take " + std::to_string(std::lround(cost.seconds)) +
                     " s. Ask for a lower quality, a smaller picture, or more seconds.",
                 "/max_seconds", "at least the expected seconds, up to 86400");
}

Status too_slow(const FrameRequest& request, const FrameCost& cost) {
  return failure(Code::invalid,
                 "Drawing this frame took longer than " + std::to_string(std::lround(request.max_seconds)) +
                     " s, which it is stopped after; " + std::to_string(std::lround(cost.seconds)) +
                     " s were expected. Ask for a lower quality, a smaller picture, or more seconds.",
                 "/max_seconds", "more seconds, up to 86400");
}

FrameProgress progress_of(const FrameJob& job, bool is_drawn) {
  const double passed = job.since_start.milliseconds() - job.paused;
  const double share = is_drawn && job.cost() > 0 ? std::clamp(passed / job.cost(), 0.0, 0.99) : 0;
  const FrameRequest& request = job.order.request;
  return {request.view, request.width, request.height, share, job.since_request.seconds(), job.order.plan.cost.seconds};
}

}  // namespace pelage
