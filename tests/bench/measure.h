// What the programs that measure frames share beside costs: a renderer.
#pragma once

#include <memory>

#include "renderer/frame/renderer.h"
#include "renderer/gl/context/context.h"
#include "tests/bench/cost.h"
#include "tests/support/furred_model.h"

namespace pelage::bench {

struct BenchRenderer {
  std::unique_ptr<Context> context;
  std::unique_ptr<Renderer> renderer;  // dies before its context
};
/// Prints what there is; on failure prints why, and both are null.
BenchRenderer open_renderer(GlChoice gl = GlChoice::egl, const RendererOptions& options = {});

/// A picture of a frame and what it cost. Ends the program when it cannot be drawn.
Image draw(Renderer& renderer, const FurFrame& frame, DrawTimes* times = nullptr);

}  // namespace pelage::bench
