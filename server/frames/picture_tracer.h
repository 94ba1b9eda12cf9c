// The interface of the tracer that the trace queue uses.
#pragma once

#include <memory>

#include "base/status.h"
#include "protocol/commands/frame.h"
#include "renderer/strands/tracer.h"
#include "server/frames/linear_picture.h"
#include "server/scene/scene.h"

namespace pelage {

/// Returns the request that traces the pictures of a progressive request: traced strands, without `progressive`.
FrameRequest traced_request(const FrameRequest& request);

/// Traces one picture at a time, called from one thread: the tracer with its inputs from the scene and the render
/// thread.
class PictureTracer {
 public:
  virtual ~PictureTracer() = default;

  /// Begins a picture of the scene, with 0 passes, and returns its revision. Fails as Tracer::begin and FrameService
  /// do.
  virtual Result<Revision> begin(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                                 const GoOn& go_on) = 0;
  /// Calls Tracer::add_pass.
  virtual Status add_pass(const GoOn& go_on) = 0;

  /// A picture set aside for another one.
  struct SuspendedPicture {
    virtual ~SuspendedPicture() = default;
  };
  /// Sets the picture aside, so that another may be begun or resumed.
  virtual std::unique_ptr<SuspendedPicture> suspend() = 0;
  /// Returns the bytes of memory that a picture takes when it is set aside.
  virtual std::size_t bytes() const = 0;
  /// Continues a picture at its own revision, with the same bits as without the interruption. Fails as `begin` does.
  virtual Status resume(std::unique_ptr<SuspendedPicture> suspended, const GoOn& go_on) = 0;
  virtual TraceReport report() const = 0;
  /// Returns the picture so far. Requires at least one pass.
  virtual LinearPicture picture() const = 0;
};

}  // namespace pelage
