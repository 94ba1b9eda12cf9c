// What tracing a picture takes, measured by a small one.
#pragma once

#include "protocol/commands/frame.h"
#include "protocol/commands/quality.h"

namespace pelage {

/// The small picture that tells what `request`, a frame of strands, costs: two passes at a quarter of its size.
FrameRequest probe_of(const FrameRequest& request);

/// `probe`: of `request`, as traced. Growing strands takes the same for any size, a pass as long as there are pixels;
/// the request's own seconds are its most.
FrameCost trace_cost(const FrameRequest& request, const TraceReport& probe);

}  // namespace pelage
