// The tracer, with what it needs of a scene: its copy, and a picture of what lies under the strands.
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
  /// `threads` that trace where no other thread of the machine wants to, 0 for as many as there are cores; `memory`
  /// bounds strands, their index and the film, bytes. The frame service outlives it.
  SceneTracer(FrameService& frames, int threads, std::size_t memory);

  Result<Revision> begin(const std::shared_ptr<Scene>& scene, const FrameRequest& request, const GoOn& go_on) override;
  Status add_pass(const GoOn& go_on) override { return tracer_.add_pass(go_on); }
  std::unique_ptr<Aside> set_aside() override;
  std::size_t bytes() const override { return tracer_.picture_bytes() + begun_->scene->bytes(); }
  Status resume(std::unique_ptr<Aside> aside, const GoOn& go_on) override;
  TraceReport report() const override { return tracer_.report(); }
  LinearPicture picture() const override;

 private:
  /// A picture with what it is traced from.
  struct Begun : Aside {
    SnapshotPtr scene;
    bool masked = false;
    SceneView view() const { return scene->view(masked); }
    MovedDirection opening, closing;  // null for fur at rest, and for none that is blurred
    std::vector<Aov> aovs;
    LinearPicture picture;  // all but report and AOVs
    std::shared_ptr<Tracer::Picture> traced;
  };
  /// Calls use(model, fields) with views of what a picture is traced from.
  Status with_views(const Begun& begun,
                    const std::function<Status(const FurModel&, const std::vector<FurFields>&)>& use);
  const ModelArrays& arrays_of(const Begun& begun);

  FrameService& frames_;
  Tracer tracer_;
  std::unique_ptr<Begun> begun_;
  // Of the last model in its colours, which `arrays_of_` keeps alive.
  SnapshotPtr arrays_of_;
  std::uint64_t arrays_id_ = 0;  // copy_id of these
  ModelArrays arrays_;
};

}  // namespace pelage
