#include "server/frames/trace_cost.h"

#include <algorithm>

namespace pelage {

namespace {

constexpr int probe_reduction = 4, probe_passes = 2;
constexpr double safety = 2;  // docs/notes/2026-11-25-models.md

double pixels(const FrameRequest& frame) {
  return static_cast<double>(frame.width) * frame.height * frame.drawn_share();
}

}  // namespace

FrameRequest probe_of(const FrameRequest& request) {
  FrameRequest probe = request;
  probe.width = std::max(1, request.width / probe_reduction);
  probe.height = std::max(1, request.height / probe_reduction);
  probe.crop.reset();
  probe.knobs.trace.passes = probe_passes;
  probe.knobs.trace.noise = probe.knobs.trace.seconds = 0;
  probe.view.clear();
  return probe;
}

FrameCost trace_cost(const FrameRequest& request, const TraceReport& probe) {
  const Tracing& trace = request.knobs.trace;
  const double pass_ms = probe.trace_ms / probe_passes * pixels(request) / pixels(probe_of(request));
  const double seconds = (probe.grow_ms + trace.passes * pass_ms) / 1e3;
  return {trace.seconds > 0 ? std::min(seconds, trace.seconds) : seconds, safety};
}

}  // namespace pelage
