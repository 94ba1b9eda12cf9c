// The story of a frame, whoever draws it: strands that are rasterized, traced to the end, or first the one and then the
// other.
#pragma once

#include "server/frames/frame_service.h"
#include "server/frames/trace_queue.h"

namespace pelage {

/// Thread-safe. Both services outlive it.
class PictureService {
 public:
  PictureService(FrameService& frames, TraceQueue& traces) : frames_(frames), traces_(traces) {}

  /// The story of a frame: what of the scene it shows, with which knobs, drawn, finished, and the function that encodes
  /// its file, on any thread, while other frames are drawn. That is called at most once, before the services end. Fails
  /// as FrameService and TraceQueue::trace do.
  using Encode = std::function<FrameAnswer(const FileTexts& texts)>;
  Result<Encode> begin_frame(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                             const std::function<bool()>& abandoned = {});
  /// All of it. Of a request with `progressive` this is the first picture, and tracing better ones begins.
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
  Result<DrawnFrame> trace(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                           const std::function<bool()>& abandoned);

  FrameService& frames_;
  TraceQueue& traces_;
};

}  // namespace pelage
