#include "server/frames/traced_picture.h"

namespace pelage {

FrameRequest traced_request(const FrameRequest& request) {
  if (!request.progressive) return request;
  FrameRequest traced = request;
  traced.knobs = knobs_of(Tier::reference);
  traced.knobs.eye_steps = request.knobs.eye_steps;
  traced.knobs.trace = *request.progressive;
  traced.progressive.reset(), traced.budget_ms.reset(), traced.max_error.reset();
  return traced;
}

std::vector<Aov> traced_aovs(const FrameRequest& request) {
  return is_linear(request.format) ? request.aovs : std::vector{Aov::beauty};
}

Knobs knobs_of(const TracedPicture& picture) {
  Knobs knobs = picture.frame->knobs;
  knobs.trace.passes = picture.report.passes;
  knobs.trace.seconds = 0;
  return knobs;
}

}  // namespace pelage
