// Fur in shells, as the papers on GPU fur have it: skin and shells by a GL.
#pragma once

#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <string>

#include "base/status.h"
#include "protocol/commands/answers.h"
#include "renderer/coat/slices.h"
#include "renderer/gl/handles.h"
#include "renderer/gl/sync.h"
#include "renderer/image/float_image.h"
#include "renderer/input/fur_scene.h"
#include "renderer/shells/fur/fur_pass.h"
#include "renderer/shells/shadow_maps.h"
#include "renderer/shells/sorted/sorted_pass.h"
#include "renderer/upload/model_buffers.h"
#include "renderer/upload/textures.h"

namespace pelage {

/// Belongs to the thread and the context that it was made on.
class ShellsRenderer {
 public:
  /// Fails (unavailable) when a program cannot be built. `sorted_bytes` bounds the fragments that a sorted frame keeps
  /// at a time (SortedPass).
  static Result<std::unique_ptr<ShellsRenderer>> create(const Gl& gl,
                                                        std::size_t sorted_bytes = SortedPass::default_bytes,
                                                        CoatSource coats = bake_here);

  bool has(std::uint64_t model) const { return models_.contains(model); }
  /// Sends a model that the renderer does not have yet, with its fields.
  UploadCount add(const FurModel& model, const FurFields& fields);
  /// Sends the dirty ranges of a model that it has.
  UploadCount update(std::uint64_t model, const FurFields& fields);

  /// Draws premultiplied linear light of a model that it has, in the size that the frame's scale asks for: skin and
  /// fur, and nothing else of a frame. Fails with unavailable when the GL was reset or does not answer within a minute:
  /// it is then lost, and so is all that was sent. Fails with too_large when there is no memory for the size, and with
  /// invalid when the GL cannot sort as asked.
  Result<FloatImage> draw(const FurFrame& frame, FrameCounters& counters);

  bool lost() const { return lost_; }

  /// Returns whether the slices of the frame's coat are not there yet: it gets them from its source once it draws.
  bool misses_coat(const FurFrame& frame) const { return !has(frame.coat()); }
  /// What all copies of a model (FurModel::original) take in memory, with their GL objects.
  std::size_t bytes_of(std::uint64_t original) const;
  /// Storage of all GL objects: models, coats, targets, maps.
  std::size_t gl_bytes() const { return gl_.held_bytes(); }
  /// Drops all copies of a model (FurModel::original).
  void forget(std::uint64_t original);
  /// Drops the copies of all models, and the target.
  void forget_all();

 private:
  ShellsRenderer(const Gl& gl, std::size_t sorted_bytes, CoatSource coats);
  Status programs() const;  // whether all programs so far were built
  bool has(const Coat& coat) const;
  const CoatTextures& textures_of(const Coat& coat);
  bool fit_target(const FurFrame& frame);
  /// What a frame reads, made and bound; its drawing views the last three.
  FurDrawing prepare(const FurFrame& frame, ModelBuffers& model, const CoatTextures& coat,
                     ModelBuffers::DrawLists& lists);
  void bind_blocks(const FurFrame& frame, const FrameBlock& block);
  Result<FloatImage> drawn(const FurFrame& frame, FrameCounters& counters);
  Status draw_shells(const FurDrawing& drawing);
  Status draw_sorted(const FurDrawing& drawing);
  Result<FloatImage> read_back() const;

  const Gl& gl_;
  CoatSource coat_source_;
  FurPass fur_;
  ShadowMaps shadows_;
  SortedPass sorted_;
  std::map<std::uint64_t, ModelBuffers> models_;
  std::list<CoatTextures> coats_;  // most recently used first
  PatternTextures pattern_;
  TuftTextures tufts_;
  PaintTextures paint_;
  ScatteringTextures scattering_;
  Buffer frame_block_, skin_block_;
  FragmentCounter fragments_;
  bool lost_ = false;
  RenderTarget target_;  // kept for the next frame of that size
};

}  // namespace pelage
