// Frames, whoever draws them: the one door in front of the GL passes and of the marcher.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "protocol/base/status.h"
#include "renderer/frame/gl_renderer.h"
#include "renderer/frame/marched_renderer.h"

namespace pelage {

struct RendererOptions {
  std::size_t sorted_bytes = SortedPass::default_bytes;  // fragments that a sorted frame keeps at a time (SortedPass)
  int march_threads = 0;  // that fur is marched on where the GL is software; 0: the GL draws all
};

/// Belongs to the thread and the context that it was made on.
class Renderer {
 public:
  /// Fails (unavailable) when a program cannot be built.
  static Result<std::unique_ptr<Renderer>> create(const Gl& gl, const RendererOptions& options = {});

  bool has(std::uint64_t model) const { return gl_->has(model); }
  /// Takes a model that the renderer does not have yet, with its fields.
  UploadCount add(const FurModel& model, const FurFields& fields);
  /// Takes over the dirty ranges of a model that it has.
  UploadCount update(std::uint64_t model, const FurFields& fields);

  /// Draws a model that it has; after changes of its fields alone, the marcher draws only the part of the picture that
  /// they may touch, with the same bits. With `pause` a long drawing is done in pieces, with the same bits, and the
  /// pause is called in between; its time does not count. Fails with conflict when the pause gives the drawing up, with
  /// unavailable when the GL does not answer within a minute, with too_large when there is no memory for the size, and
  /// with invalid when the GL cannot sort as asked.
  Result<Image> draw(const FurFrame& frame, DrawTimes* times = nullptr, const Pause& pause = {});
  /// The same picture with 16 bits.
  Result<Image16> draw_deep(const FurFrame& frame, DrawTimes* times = nullptr, const Pause& pause = {});
  /// Those of light by whoever draws the frame's, the others by the GL. This and the rest as GlRenderer has them.
  Result<std::vector<FloatImage>> draw_aovs(const FurFrame& frame, std::span<const Aov> aovs,
                                            DrawTimes* times = nullptr, const Pause& pause = {});
  Result<Backplate> draw_backplate(const FurFrame& frame, DrawTimes* times = nullptr);
  Result<Image> finish(const FurFrame& frame, const FloatImage& light, DrawTimes* times = nullptr);
  Result<Image16> finish_deep(const FurFrame& frame, const FloatImage& light, DrawTimes* times = nullptr);

  /// Makes the next frame be drawn whole, for who measures or doubts.
  void clear_view_cache();
  /// What all copies of a model (FurModel::original) take in memory, with their GL objects.
  std::size_t bytes_of(std::uint64_t original) const;
  /// Storage of all GL objects: models, coats, targets, maps.
  std::size_t gl_bytes() const { return gl_->gl_bytes(); }
  /// Drops all copies of a model (FurModel::original).
  void forget(std::uint64_t original);
  /// Drops the copies of all models, and the pictures kept of them.
  void forget_all();

 private:
  /// Draws a frame by the marcher, and adds what the GL was sent for it.
  template <class Draw>
  auto march(DrawTimes* times, const Draw& draw);
  bool marches(const FurFrame& frame) const { return marched_ && MarchedRenderer::draws(frame); }

  std::unique_ptr<GlRenderer> gl_;
  std::unique_ptr<MarchedRenderer> marched_;  // null where the GL draws all
};

}  // namespace pelage
