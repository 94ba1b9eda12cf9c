// The tracer for scenes: holds a snapshot of the scene, and the backplate drawn by the frame service.
#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "server/frames/frame_service.h"
#include "server/frames/fur_view.h"
#include "server/frames/picture_tracer.h"

namespace pelage {

class SceneTracer : public PictureTracer {
 public:
  /// `threads` is the number of threads, which trace at low priority, 0 for as many as there are cores. `memory` bounds
  /// strands, their index and the film, in bytes. The frame service must outlive this object.
  SceneTracer(FrameService& frames, int threads, std::size_t memory);

  Result<Revision> begin(const std::shared_ptr<Scene>& scene, const FrameRequest& request, const GoOn& go_on) override;
  Status add_pass(const GoOn& go_on) override { return tracer_.add_pass(go_on); }
  std::unique_ptr<SuspendedPicture> suspend() override;
  std::size_t bytes() const override { return tracer_.picture_bytes() + current_->scene->bytes(); }
  Status resume(std::unique_ptr<SuspendedPicture> suspended, const GoOn& go_on) override;
  TraceReport report() const override { return tracer_.report(); }
  LinearPicture picture() const override;

 private:
  /// A picture with its inputs.
  struct TracedPicture : SuspendedPicture {
    SnapshotPtr scene;
    bool masked = false;
    SceneView view() const { return scene->view(masked); }
    MovedDirection opening, closing;  // at the shutter's ends; null for fur at rest, `closing` also without blur
    std::vector<Aov> aovs;
    LinearPicture picture;  // without report and AOVs
    std::shared_ptr<Tracer::Picture> traced;
  };
  /// Calls use(model, fields) with views of a picture's inputs.
  Status with_views(const TracedPicture& begun,
                    const std::function<Status(const FurModel&, const std::vector<FurFields>&)>& use);
  const ModelArrays& arrays_of(const TracedPicture& begun);

  FrameService& frames_;
  Tracer tracer_;
  std::unique_ptr<TracedPicture> current_;
  // Cache of the last model's arrays, which `arrays_of_` keeps alive.
  SnapshotPtr arrays_of_;
  std::uint64_t arrays_id_ = 0;  // copy_id of the cached arrays
  ModelArrays arrays_;
};

}  // namespace pelage
