#include "server/frames/picture_tracer.h"

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

}  // namespace pelage
