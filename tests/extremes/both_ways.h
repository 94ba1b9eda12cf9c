// A scene drawn by shells and as strands that are rasterized and traced, with every number of every layer looked at.
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

/// Pictures of one request: rasterized strands, shells in both orders, and traced strands in both transports.
class BothWays {
 public:
  /// No more strands than `max_count` on a tile of a coat.
  explicit BothWays(Renderer& renderer, int max_count = std::numeric_limits<int>::max())
      : renderer_(renderer), max_count_(max_count) {}

  /// Refused as drawing and tracing are. `complaint` says which number of which layer is wrong, "" where all are fine.
  Status look_at(Scene& scene, const FrameRequest& request, std::string& complaint);

  /// Layers of shells or of rasterized strands with the request's own knobs, or of traced ones.
  Result<std::vector<FloatImage>> draw(Scene& scene, const FrameRequest& request);
  /// As a client sees it, in 8 bits.
  Result<Image> show(Scene& scene, const FrameRequest& request);
  Result<std::vector<FloatImage>> trace(Scene& scene, const FrameRequest& request);

  std::size_t pictures() const { return pictures_; }

 private:
  FurFrame sync(Scene& scene, const FrameRequest& request);
  Status check(Result<std::vector<FloatImage>> images, const char* way, std::string& complaint);

  Renderer& renderer_;
  int max_count_;
  Tracer tracer_{2, std::size_t{1} << 28, false};
  std::size_t pictures_ = 0;
};

/// A request as one of rasterized strands, with its scale up to 1. A difference is of two revisions, which nothing here
/// has.
FrameRequest rasterized(FrameRequest request);

/// Returns what is wrong with the AOVs of a picture, or "" if nothing is: all have to be finite, light not negative,
/// and shares in [0, 1].
std::string complaint_about(const std::vector<FloatImage>& aovs);

}  // namespace pelage::testing
