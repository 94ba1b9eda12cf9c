// The ray tracer of fur, which adds pass by pass, and its backplate: skin, bare skin and eyes in the light of all
// lights, drawn by the rasterizer without fur, shadows and ground.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "base/status.h"
#include "renderer/image/float_image.h"
#include "renderer/input/fur_scene.h"

namespace pelage {

/// Pictures of the same size, an integer multiple of the frame's, in the conventions of Renderer::draw_aovs.
struct Backplate {
  FloatImage beauty;  // premultiplied by alpha, which is 0 where there is neither skin nor eye
  FloatImage direct;  // the part of `beauty` that comes from lights
  FloatImage albedo;
  FloatImage normal;
  FloatImage depth;  // 1 / distance along the view direction, 1 / sizes; 0 for none
};

// The quality tier `reference`: the coat as strands, ray traced in passes. It needs no GL: skin and eyes come as a
// rasterized picture (Backplate), so that they look the same in all tiers.

/// Called by each tracing thread between small steps of work. It may block the thread; returning false cancels the
/// work.
using GoOn = std::function<bool()>;

class Tracer {
 public:
  /// `memory`: limit for strands, their index and the film, bytes. `yielding`: threads run only while no other thread
  /// of the machine needs the core.
  Tracer(int threads, std::size_t memory, bool yielding);
  ~Tracer();

  /// Checks, before any work, that a picture with its backplate and AOVs fits into that memory. Fails with too_large if
  /// not.
  Status admit(int width, int height, std::span<const Aov> aovs, bool filter) const;
  /// Grows what changed since the last scene, and begins a picture with 0 passes. The views are not stored. Paths
  /// scatter by energy_conserving, as the API contract says. Fails with too_large if memory does not suffice, and with
  /// unavailable if `go_on` returned false.
  Status begin(const FurModel& model, EachCoat<FurFields> fields, const FurFrame& frame, Backplate base,
               std::span<const Aov> aovs, const GoOn& go_on);
  /// Adds a pass. If it was the last one, the report then says why. Fails with unavailable if `go_on` returned false;
  /// the picture then has to be begun again.
  Status add_pass(const GoOn& go_on);

  /// A partly traced picture, without strands.
  struct Picture;
  /// Removes the picture from the tracer, which can then begin or resume another.
  std::shared_ptr<Picture> suspend();
  /// Returns the bytes that the picture takes.
  std::size_t picture_bytes() const;
  /// Continues a picture that was set aside, with the same bits as without the pause. Model and fields must be those
  /// that it was begun with. Fails as `begin` does.
  Status resume(const FurModel& model, EachCoat<FurFields> fields, std::shared_ptr<Picture> picture, const GoOn& go_on);

  TraceReport report() const;
  /// Returns an AOV of a picture with at least one pass, in the conventions of Renderer::draw_aovs.
  FloatImage aov(Aov aov) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pelage
