// Estimates the cost of tracing a picture from a small probe.
#pragma once

#include "protocol/commands/frame.h"
#include "protocol/commands/quality.h"

namespace pelage {

/// Returns the request of the probe for `request`, a frame of traced strands: two passes at a quarter of its size.
FrameRequest probe_of(const FrameRequest& request);

/// Returns the estimated cost of `request`; `probe` is the report of its probe. Growing strands takes the same time for
/// any size, and a pass takes time in proportion to the pixels; the request's own seconds are an upper limit.
FrameCost trace_cost(const FrameRequest& request, const TraceReport& probe);

}  // namespace pelage
