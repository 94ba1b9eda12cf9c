// What traces a picture.
#pragma once

#include <memory>

#include "base/status.h"
#include "protocol/commands/frame.h"
#include "renderer/strands/tracer.h"
#include "server/frames/linear_picture.h"
#include "server/scene/scene.h"

namespace pelage {

/// The request that draws a progressive picture's pictures: by strands, and without `progressive`.
FrameRequest traced_request(const FrameRequest& request);

/// Traces a picture at a time, on one thread: the tracer with what it needs of a scene and of the render thread.
class PictureTracer {
 public:
  virtual ~PictureTracer() = default;

  /// Begins a picture of the scene as it is now, of no passes; the revision. Fails as Tracer::begin and FrameService
  /// do.
  virtual Result<Revision> begin(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                                 const GoOn& go_on) = 0;
  /// As Tracer::add_pass.
  virtual Status add_pass(const GoOn& go_on) = 0;

  /// A picture that gave way to another.
  struct Aside {
    virtual ~Aside() = default;
  };
  /// Takes the picture out; another may be begun or resumed then.
  virtual std::unique_ptr<Aside> set_aside() = 0;
  /// What that takes in memory.
  virtual std::size_t bytes() const = 0;
  /// Continues a picture, at its own revision and with the same bits as without the interruption. Fails as `begin`
  /// does.
  virtual Status resume(std::unique_ptr<Aside> aside, const GoOn& go_on) = 0;
  virtual TraceReport report() const = 0;
  /// Returns the picture so far, of at least one pass.
  virtual LinearPicture picture() const = 0;
};

}  // namespace pelage
