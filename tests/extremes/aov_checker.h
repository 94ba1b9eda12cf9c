// Draws a scene with shells, rasterized strands and traced strands, and checks every number of every AOV.
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "protocol/commands/frame.h"
#include "renderer/frame/renderer.h"
#include "renderer/input/fur_scene.h"
#include "renderer/strands/tracer.h"
#include "server/scene/scene.h"

namespace pelage::testing {

/// Pictures of one request: rasterized strands, shells in both fragment orders, and traced strands with both
/// transports.
class AovChecker {
 public:
  /// Caps the number of strands on a tile of a coat at `max_count`.
  explicit AovChecker(Renderer& renderer, int max_count = std::numeric_limits<int>::max())
      : renderer_(renderer), max_count_(max_count) {}

  /// Returns the first refusal by drawing or tracing. Adds a line to `complaint` for each picture with a wrong number.
  Status look_at(Scene& scene, const FrameRequest& request, std::string& complaint);

  /// Returns the AOVs of shells or rasterized strands, with the request's own knobs; `trace` returns those of traced
  /// strands.
  Result<std::vector<FloatImage>> draw(Scene& scene, const FrameRequest& request);
  /// Returns the 8-bit picture that a client sees.
  Result<Image> show(Scene& scene, const FrameRequest& request);
  Result<std::vector<FloatImage>> trace(Scene& scene, const FrameRequest& request);

  std::size_t pictures() const { return pictures_; }

 private:
  FurFrame sync(Scene& scene, const FrameRequest& request);
  Status check(Result<std::vector<FloatImage>> images, const char* method, std::string& complaint);

  Renderer& renderer_;
  int max_count_;
  Tracer tracer_{2, std::size_t{1} << 28, false};
  std::size_t pictures_ = 0;
};

/// Turns a request into one of rasterized strands, with a scale of at most 1. Drops the overlay `difference`, which
/// needs two revisions; nothing here has them.
FrameRequest rasterized(FrameRequest request);

/// Returns what is wrong with the AOVs of a picture, or "" if nothing is: all have to be finite, light not negative,
/// and shares in [0, 1].
std::string complaint_about(const std::vector<FloatImage>& aovs);

}  // namespace pelage::testing
