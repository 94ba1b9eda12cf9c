// The ray tracer of fur, pass by pass, and its backplate: skin, bare skin and eyes in the light of all lights, drawn
// by the shells' passes without fur, shadows and ground.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "base/status.h"
#include "renderer/image/float_image.h"
#include "renderer/input/fur_scene.h"

namespace pelage {

/// Pictures of one size, which is a whole multiple of the frame's; conventions of Renderer::draw_aovs.
struct Backplate {
  FloatImage beauty;  // multiplied by alpha, which is 0 where there is neither skin nor eye
  FloatImage direct;  // of that the part of lights
  FloatImage albedo;
  FloatImage normal;
  FloatImage depth;  // 1 / distance along the view, 1 / sizes; 0 for none
};

// The tier `reference`: the coat as strands, ray traced in passes. No GL: skin and eyes come as a picture that was
// rasterized (Backplate), so that they look the same in all tiers.

/// Asked by each tracing thread between small steps of work. It may block the thread; false ends the work.
using GoOn = std::function<bool()>;

class Tracer {
 public:
  /// `memory` bounds strands, their index and the film, bytes. With `yielding`, threads run only where no other thread
  /// of the machine wants to.
  Tracer(int threads, std::size_t memory, bool yielding);
  ~Tracer();

  /// Returns whether a picture may be begun in that memory with its backplate and its AOVs, before any of it is made.
  /// too_large where not.
  Status admit(int width, int height, std::span<const Aov> aovs, bool filter) const;
  /// Grows what changed since the last scene, and begins a picture of no passes. The views are not stored. Paths
  /// scatter by energy_conserving, as the contract has it. Fails with too_large when memory is not enough, and with
  /// unavailable when `go_on` returned false.
  Status begin(const FurModel& model, EachCoat<FurFields> fields, const FurFrame& frame, Backplate base,
               std::span<const Aov> aovs, const GoOn& go_on);
  /// Adds a pass, and says in the report why it was the last one. Fails with unavailable when `go_on` returned false;
  /// the picture then has to be begun again.
  Status add_pass(const GoOn& go_on);

  /// A picture as far as it is traced, without strands.
  struct Picture;
  /// Takes the picture out of the tracer, which then begins or resumes another.
  std::shared_ptr<Picture> set_aside();
  /// Returns the bytes that the picture takes.
  std::size_t picture_bytes() const;
  /// Continues a picture, with the same bits as without the pause; model and fields are those that it was begun with.
  /// Fails as `begin` does.
  Status resume(const FurModel& model, EachCoat<FurFields> fields, std::shared_ptr<Picture> picture, const GoOn& go_on);

  TraceReport report() const;
  /// Returns an AOV of a picture with at least one pass, in the conventions of Renderer::draw_aovs.
  FloatImage aov(Aov aov) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pelage
