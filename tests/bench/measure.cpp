#include "tests/bench/measure.h"

#include <cstdio>
#include <cstdlib>

namespace pelage::bench {

BenchRenderer open_renderer(GlChoice gl, const RendererOptions& options) {
  Result<std::unique_ptr<Context>> context = select_context(gl, 0);
  if (!context) return std::fprintf(stderr, "%s\n", context.status().message.c_str()), BenchRenderer{};
  Result<std::unique_ptr<Renderer>> renderer =
      *context ? Renderer::create((*context)->gl(), options) : std::make_unique<Renderer>(options);
  if (!renderer) return std::fprintf(stderr, "%s\n", renderer.status().message.c_str()), BenchRenderer{};
  std::printf("%s\n", *context ? (*context)->description().c_str() : MarchedRenderer::description().c_str());
  return {std::move(context).value(), std::move(renderer).value()};
}

testing::FurredModel speed_model(int number) {
  if (number == 0) return testing::furred({Builtin::creature, 5000});
  if (number == 1) return testing::furred_file("../shared/meshes/spot.ply");
  return testing::furred({Builtin::torus, 5000});
}

const char* speed_name(int number) { return number == 0 ? "creature" : number == 1 ? "spot" : "torus"; }

Image draw(Renderer& renderer, const FurFrame& frame, DrawTimes* times) {
  renderer.clear_view_cache();
  Result<Image> image = renderer.draw(frame, times);
  if (!image) std::fprintf(stderr, "%s\n", image.status().message.c_str()), std::exit(4);
  return std::move(image).value();
}

}  // namespace pelage::bench
