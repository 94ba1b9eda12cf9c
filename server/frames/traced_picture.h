// A picture that strands were traced for, and what traces it.
#pragma once

#include <memory>
#include <vector>

#include "protocol/base/status.h"
#include "protocol/commands/answers.h"
#include "protocol/commands/frame.h"
#include "renderer/image/float_image.h"
#include "renderer/input/fur_scene.h"
#include "renderer/strands/tracer.h"
#include "server/frames/frame_parts.h"
#include "server/scene/scene.h"

namespace pelage {

/// A traced picture as far as it is, with all that its file needs. Never changes.
struct TracedPicture {
  Revision revision = 0;
  TraceReport report = {};
  std::vector<FloatImage> aovs = {};  // those of traced_aovs(request)
  std::shared_ptr<const FurFrame> frame = {};
  ModelPlacement placement = {};
  FrameTimings timings = {};
  FrameCounters counters = {};  // of what lies under the strands
  // Of an earlier revision what it was drawn from: for as long as it lives, the renderer has it for overlays.
  std::shared_ptr<const SceneCopy> past = {};
};

/// The request that draws a progressive picture's pictures: by strands, and without `progressive`.
FrameRequest traced_request(const FrameRequest& request);

/// The AOVs that a request's file is made of: those of an EXR, else beauty.
std::vector<Aov> traced_aovs(const FrameRequest& request);

/// The knobs that trace the same picture again.
Knobs knobs_of(const TracedPicture& picture);

/// Traces one picture at a time, on one thread: the tracer with what it needs of a scene and of the render thread.
class PictureTracer {
 public:
  virtual ~PictureTracer() = default;

  /// Begins a picture of the scene as it is now, of no passes; the revision. Fails as Tracer::begin and FrameService
  /// do.
  virtual Result<Revision> begin(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                                 const GoOn& go_on) = 0;
  /// As Tracer::add_pass.
  virtual Status add_pass(const GoOn& go_on) = 0;
  virtual TraceReport report() const = 0;
  /// Of at least one pass.
  virtual TracedPicture picture() const = 0;
};

}  // namespace pelage
