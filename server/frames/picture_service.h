// Pictures of a scene by any method: shells, strands that are traced to the end, and shells that strands improve.
#pragma once

#include "server/frames/frame_service.h"
#include "server/frames/trace_queue.h"

namespace pelage {

/// Thread-safe. Both services outlive it.
class PictureService {
 public:
  PictureService(FrameService& frames, TraceQueue& traces) : frames_(frames), traces_(traces) {}

  /// Answers as FrameService::frame and TraceQueue::trace do. A request with `progressive` is answered with shells, and
  /// tracing begins.
  Result<FrameAnswer> frame(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                            const std::function<bool()>& abandoned = {}, const FileTexts& texts = {});

  /// Returns the picture before it is finished to a file. Not for requests with `progressive`.
  Result<LinearPicture> light(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                              const std::function<bool()>& abandoned = {});

  /// Estimates the cost of drawing such a frame, without drawing it. The cost of strands is measured: they are grown,
  /// and traced for two passes at a quarter of the size; a picture that ends at its noise target may end sooner. Fails
  /// as `frame` does.
  Result<FrameCost> cost(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                         const std::function<bool()>& abandoned = {});

  /// Somebody waits for a better picture than the one seen: as TraceQueue::improve.
  Status look(const std::shared_ptr<Scene>& scene, const FrameRequest& request, SeenPicture seen);
  /// Returns whether `picture_if_better` has an answer. Does not wait.
  bool has_better_picture(const Scene& scene, const FrameRequest& request, SeenPicture seen);
  /// Returns a better picture of the revision that was seen, or the reason why there is none. Returns nothing while the
  /// picture is traced, and once the scene is newer.
  std::optional<Result<FrameAnswer>> picture_if_better(const Scene& scene, const FrameRequest& request,
                                                       SeenPicture seen);

 private:
  FrameService& frames_;
  TraceQueue& traces_;
};

}  // namespace pelage
