// The renderer of fur as shells, the layered method of the papers on GPU fur: draws skin and shells by a GL.
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

/// Belongs to the thread and the context on which it was made.
class ShellsRenderer {
 public:
  /// Fails with unavailable if a program cannot be built. `sorted_bytes` bounds the memory for the fragments of a
  /// sorted frame (SortedPass). `coats` is where slices come from.
  static Result<std::unique_ptr<ShellsRenderer>> create(const Gl& gl,
                                                        std::size_t sorted_bytes = SortedPass::default_bytes,
                                                        CoatSource coats = bake_here);

  bool has(std::uint64_t model) const { return models_.contains(model); }
  /// Sends a model that the renderer does not have yet, with its fields.
  UploadCount add(const FurModel& model, const FurFields& fields);
  /// Sends the dirty ranges of a model that it has.
  UploadCount update(std::uint64_t model, const FurFields& fields);

  /// Draws premultiplied linear light of a model that it has, at the frame's size times its scale: only skin and fur,
  /// no eyes, curves, ground or overlay. Fails with unavailable if the GL was reset or does not answer within a minute;
  /// it is then lost, with all that was sent. Fails with too_large if there is no memory for the size, and with invalid
  /// if the GL cannot sort fragments as asked.
  Result<FloatImage> draw(const FurFrame& frame, FrameCounters& counters);

  bool lost() const { return lost_; }

  /// Returns whether the slices of the frame's coat are not there yet; drawing the frame then takes them from their
  /// source.
  bool misses_coat(const FurFrame& frame) const { return !has(frame.coat()); }
  /// Returns the bytes of all copies of a model (FurModel::original), with their GL objects.
  std::size_t bytes_of(std::uint64_t original) const;
  /// Returns the bytes of all GL objects: models, coats, targets, maps.
  std::size_t gl_bytes() const { return gl_.storage_bytes(); }
  /// Drops all copies of a model (FurModel::original).
  void forget(std::uint64_t original);
  /// Drops the copies of all models, and the target.
  void forget_all();

 private:
  ShellsRenderer(const Gl& gl, std::size_t sorted_bytes, CoatSource coats);
  Status programs() const;  // fails if a program could not be built
  bool has(const Coat& coat) const;
  const CoatTextures& textures_of(const Coat& coat);
  bool fit_target(const FurFrame& frame);
  /// Makes and binds what a frame reads, and fills `lists`. The result has views of all arguments.
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
  RenderTarget target_;  // reused by the next frame of the same size
};

}  // namespace pelage
