#include "server/frames/missed_goals.h"

#include <algorithm>

#include "renderer/quality/planner.h"
#include "server/frames/frame_service.h"

namespace pelage {

std::string missed_goals(const FrameRequest& request, const FrameAnswer& answer) {
  std::string missed;
  const auto name_if = [&](bool is_missed, const char* name) {
    if (is_missed) missed += (missed.empty() ? "" : ", ") + std::string(name);
  };
  const bool traced = answer.trace && answer.trace->passes > 0;
  name_if(!traced && request.budget_ms && answer.timings.draw > *request.budget_ms * budget_margin, "budget_ms");
  name_if(!traced && request.max_error && answer.estimate &&
              std::min(1.0, answer.estimate->error * answer.estimate->error_safety) > *request.max_error,
          "max_error");
  const double seconds = request.knobs.trace.seconds;
  name_if(traced && seconds > 0 && answer.trace->grow_ms + answer.trace->trace_ms > 1e3 * seconds * budget_margin,
          "seconds");
  return missed;
}

}  // namespace pelage
