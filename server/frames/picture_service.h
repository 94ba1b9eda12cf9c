// Draws frames by any method: rasterized, traced to the end, or progressive (rasterized first, then traced).
#pragma once

#include "server/frames/frame_service.h"
#include "server/frames/trace_queue.h"

namespace pelage {

/// Thread-safe. Both services must outlive it.
class PictureService {
 public:
  PictureService(FrameService& frames, TraceQueue& traces) : frames_(frames), traces_(traces) {}

  /// Takes a snapshot, plans the knobs, draws and finishes a frame. Returns the function that encodes its file, which
  /// may run on any thread while other frames are drawn. It must be called at most once, before the services end. Fails
  /// as FrameService and TraceQueue::trace do.
  using Encode = std::function<FrameAnswer(const FileTexts& texts)>;
  Result<Encode> begin_frame(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                             const std::function<bool()>& abandoned = {});
  /// Runs begin_frame and encodes the file. For a request with `progressive` this gives the first picture, and tracing
  /// of better ones begins.
  Result<FrameAnswer> frame(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                            const std::function<bool()>& abandoned = {}, const FileTexts& texts = {});

  /// Returns the linear picture, before it is finished to a file. Not for requests with `progressive`.
  Result<LinearPicture> draw_linear(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                                    const std::function<bool()>& abandoned = {});

  /// Estimates the cost of drawing a frame, without drawing it. For traced strands the cost is measured: they are
  /// grown, and traced for two passes at a quarter of the size. A picture that ends at its noise target may end sooner.
  /// Fails as `frame` does.
  Result<FrameCost> cost(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                         const std::function<bool()>& abandoned = {});

  /// Records that a client waits for a better picture than the one it has seen (TraceQueue::improve).
  Status improve(const std::shared_ptr<Scene>& scene, const FrameRequest& request, SeenPicture seen);
  /// Returns whether `picture_if_better` has an answer. Does not wait.
  bool has_better_picture(const Scene& scene, const FrameRequest& request, SeenPicture seen);
  /// Returns a better picture of the revision that was seen, or the reason why there is none. Returns nothing while the
  /// picture is being traced, or if the scene has a newer revision.
  std::optional<Result<FrameAnswer>> picture_if_better(const Scene& scene, const FrameRequest& request,
                                                       SeenPicture seen);

 private:
  Result<DrawnFrame> trace(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                           const std::function<bool()>& abandoned);

  FrameService& frames_;
  TraceQueue& traces_;
};

}  // namespace pelage
