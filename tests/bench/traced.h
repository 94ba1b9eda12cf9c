// Traces pictures for benchmarks.
#pragma once

#include <functional>

#include "renderer/strands/tracer.h"
#include "server/frames/fur_view.h"
#include "tests/bench/measure.h"

namespace pelage::bench {

/// Begins to trace a picture of the model and returns its frame. The camera's position is `distance` times that of the
/// request. Ends the program on failure.
FurFrame begin_trace(Renderer& renderer, Tracer& tracer, const testing::FurredModel& model, const FrameRequest& request,
                     float distance = 1);

/// Adds passes until the tracer has ended, and calls `after_pass` with the report after each. Ends the program on
/// failure.
void trace_to_end(Tracer& tracer, const std::function<void(const TraceReport&)>& after_pass = {});

/// Traces the light of a whole frame. Syncs the scene to the renderer first.
FloatImage traced_light(Renderer& renderer, const SceneView& view, const FurFrame& frame);
/// The same for a request.
FloatImage traced_beauty(Renderer& renderer, const testing::FurredModel& model, const FrameRequest& request,
                         float distance = 1);

}  // namespace pelage::bench
