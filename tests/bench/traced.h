// Traced pictures for programs that measure.
#pragma once

#include <functional>

#include "renderer/strands/tracer.h"
#include "server/frames/fur_view.h"
#include "tests/bench/measure.h"

namespace pelage::bench {

/// Begins a picture of the model; ends the program when it cannot. The frame is answered. The camera stands at
/// `distance` times where the request puts it.
FurFrame begin_trace(Renderer& renderer, Tracer& tracer, const testing::FurredModel& model, const FrameRequest& request,
                     float distance = 1);

/// Adds passes until the request's end, and says after each what there is. Ends the program on failure.
void trace_to_end(Tracer& tracer, const std::function<void(const TraceReport&)>& after_pass = {});

/// Light of a whole traced picture of a frame of the scene, which the renderer need not have.
FloatImage traced_light(Renderer& renderer, const SceneView& view, const FurFrame& frame);
/// Of a request.
FloatImage traced_beauty(Renderer& renderer, const testing::FurredModel& model, const FrameRequest& request,
                         float distance = 1);

}  // namespace pelage::bench
