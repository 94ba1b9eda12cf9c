// Opens a renderer and draws frames, for benchmarks.
#pragma once

#include <memory>

#include "renderer/frame/renderer.h"
#include "renderer/gl/context/context.h"
#include "tests/bench/cost.h"
#include "tests/support/furred_model.h"

namespace pelage::bench {

struct BenchRenderer {
  std::unique_ptr<Context> context;
  std::unique_ptr<Renderer> renderer;  // declared last, so that it is destroyed before its context
};
/// Opens a renderer and prints what draws. On failure prints the reason, and both members are null.
BenchRenderer open_renderer(GlChoice gl = GlChoice::egl, const RendererOptions& options = {});

/// Draws a frame without cached views; `times` receives what it took. Ends the program on failure.
Image draw(Renderer& renderer, const FurFrame& frame, DrawTimes* times = nullptr);

}  // namespace pelage::bench
