// Pictures of a scene by any method: shells, strands that are traced to the end, and shells that strands improve.
#pragma once

#include "server/frames/frame_service.h"
#include "server/frames/trace_queue.h"

namespace pelage {

/// Thread-safe. Both services outlive it.
class PictureService {
 public:
  PictureService(FrameService& frames, TraceQueue& traces) : frames_(frames), traces_(traces) {}

  /// As FrameService::frame and TraceQueue::trace. A request with `progressive` is answered with shells, and tracing
  /// begins.
  Result<FrameAnswer> frame(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                            const std::function<bool()>& abandoned = {}, const FileTexts& texts = {});

  /// The same before it is finished to a file; without `progressive`.
  Result<LinearPicture> light(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                              const std::function<bool()>& abandoned = {});

  /// What drawing such a frame takes, without drawing it. Of strands it is measured: they are grown, and traced for two
  /// passes at a quarter of the size; a picture that ends by its noise may end sooner. As `frame` fails.
  Result<FrameCost> cost(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                         const std::function<bool()>& abandoned = {});

  /// Somebody waits for a better picture than the one seen: as TraceQueue::improve.
  Status look(const std::shared_ptr<Scene>& scene, const FrameRequest& request, SeenPicture seen);
  /// Whether `picture_if_better` has an answer. Does not wait.
  bool has_better_picture(const Scene& scene, const FrameRequest& request, SeenPicture seen);
  /// A better picture of the revision that was seen, or why there is none; nothing while it is traced, and once the
  /// scene is newer.
  std::optional<Result<FrameAnswer>> picture_if_better(const Scene& scene, const FrameRequest& request,
                                                       SeenPicture seen);

 private:
  FrameService& frames_;
  TraceQueue& traces_;
};

}  // namespace pelage
