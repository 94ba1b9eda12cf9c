#include "tests/bench/measure.h"

#include <cstdio>
#include <cstdlib>

#include "server/frames/frame_queue.h"

namespace pelage::bench {

BenchRenderer open_renderer(GlChoice gl, const RendererOptions& options) {
  Result<std::unique_ptr<Context>> context = select_context(gl, 0);
  if (!context) return std::fprintf(stderr, "%s\n", context.status().message.c_str()), BenchRenderer{};
  Result<std::unique_ptr<Renderer>> renderer =
      *context ? Renderer::create((*context)->gl(), options) : std::make_unique<Renderer>(options);
  if (!renderer) return std::fprintf(stderr, "%s\n", renderer.status().message.c_str()), BenchRenderer{};
  std::printf("%s\n", drawn_by(context->get(), (*renderer)->strands_by_gl()).c_str());
  return {std::move(context).value(), std::move(renderer).value()};
}

Image draw(Renderer& renderer, const FurFrame& frame, DrawTimes* times) {
  renderer.clear_view_cache();
  Result<Image> image = renderer.draw(frame, times);
  if (!image) std::fprintf(stderr, "%s\n", image.status().message.c_str()), std::exit(4);
  return std::move(image).value();
}

}  // namespace pelage::bench
