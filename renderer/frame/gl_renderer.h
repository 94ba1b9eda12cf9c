// Frames by a GL: the fixed, ordered list of passes, and the GPU copies of models and coats that they read.
#pragma once

#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "protocol/base/status.h"
#include "protocol/commands/answers.h"
#include "renderer/frame/draw_times.h"
#include "renderer/frame/pieces.h"
#include "renderer/frame/shadow_maps.h"
#include "renderer/gl/handles.h"
#include "renderer/gl/sync.h"
#include "renderer/image/float_image.h"
#include "renderer/image/image.h"
#include "renderer/input/fur_scene.h"
#include "renderer/passes/aovs/aovs_pass.h"
#include "renderer/passes/curves/curves_pass.h"
#include "renderer/passes/eye/eye_pass.h"
#include "renderer/passes/fur/fur_pass.h"
#include "renderer/passes/ground/ground_pass.h"
#include "renderer/passes/guard_hairs/guard_hairs_pass.h"
#include "renderer/passes/resolve/resolve_pass.h"
#include "renderer/passes/sorted/sorted_pass.h"
#include "renderer/upload/model_buffers.h"
#include "renderer/upload/textures.h"

namespace pelage {

/// Belongs to the thread and the context that it was made on.
class GlRenderer {
 public:
  /// Fails (unavailable) when a program cannot be built. `sorted_bytes` bounds the fragments that a sorted frame keeps
  /// at a time (SortedPass).
  static Result<std::unique_ptr<GlRenderer>> create(const Gl& gl, std::size_t sorted_bytes = SortedPass::default_bytes,
                                                    CoatSource coats = bake_here);

  bool has(std::uint64_t model) const { return models_.contains(model); }
  /// Sends a model that the renderer does not have yet, with its fields.
  UploadCount add(const FurModel& model, const FurFields& fields);
  /// Sends the dirty ranges of a model that it has.
  UploadCount update(std::uint64_t model, const FurFields& fields);

  /// Draws a model that it has. With `pause` a long drawing is done in pieces, with the same bits, and the pause is
  /// called in between; its time does not count. Fails with conflict when the pause gives the drawing up, with
  /// unavailable when the GL does not answer within a minute, with too_large when there is no memory for the size, and
  /// with invalid when the GL cannot sort as asked. `overlay`: what lies over it where the frame has one, of the
  /// frame's size, sRGB with straight alpha; null for none.
  Result<Image> draw(const FurFrame& frame, const FloatImage* overlay, DrawTimes* times, const Pause& pause);
  /// The same picture with 16 bits.
  Result<Image16> draw_deep(const FurFrame& frame, const FloatImage* overlay, DrawTimes* times, const Pause& pause);
  /// As Renderer has them.
  Result<std::vector<FloatImage>> draw_aovs(const FurFrame& frame, std::span<const Aov> aovs,
                                            DrawTimes* times = nullptr, const Pause& pause = {});

  /// What was asked of the GL since this was last called or a frame was drawn; fragments are left out.
  FrameCounters take_counts() const;

  /// As Renderer has it.
  std::optional<CoatNeed> missing_coat(const FurFrame& frame) const;
  /// What all copies of a model (FurModel::original) take in memory, with their GL objects.
  std::size_t bytes_of(std::uint64_t original) const;
  /// Storage of all GL objects: models, coats, targets, maps.
  std::size_t gl_bytes() const { return gl_.held_bytes(); }
  /// Drops all copies of a model (FurModel::original).
  void forget(std::uint64_t original);
  /// Drops the copies of all models, and the targets.
  void forget_all();

 private:
  GlRenderer(const Gl& gl, std::size_t sorted_bytes, CoatSource coats);
  Status programs() const;  // whether all programs so far were built
  /// Makes the targets of the frame's size, with a picture of a format.
  Status prepare_targets(const FurFrame& frame, GLenum picture);
  /// Once a frame is drawn: drops targets that are too large to be kept.
  void drop_large_targets();
  /// Makes a target anew where it is of another kind; whether it could be made.
  bool fit(RenderTarget& target, GLenum format, int width, int height, bool depth);
  bool has(const Coat& coat) const;
  const CoatTextures& textures_of(const Coat& coat);
  const CoatTextures& add(const Coat& coat, const Slices& slices);
  /// Gets a coat that is not there yet while the pause is called; false when that gives the drawing up.
  bool bake(const Coat& coat, const Pause& pause);
  FrameCounters take_counters() const;  // waits for the GL
  /// What a frame draws, with its blocks and maps bound.
  struct Prepared;
  /// `part` is what will be drawn; all of the picture without it.
  Prepared prepare_scene(const FurFrame& frame, const std::optional<Area>& part, DrawTimes& times);
  FrameBlock block_of(const FurFrame& frame);
  ShellView shell_view(const FurFrame& frame, const FrameBlock& block, const std::optional<Area>& part) const;
  void prepare_colours(const FurFrame& frame, ModelBuffers& model);  // patterns and paint
  void bind_blocks(const FurFrame& frame, const FrameBlock& block);
  /// The model and all that grows on it or is set into it, in the order of blending, into the bound target. `outputs`
  /// are the #define lines of what is written beside light.
  void draw_body(const FurFrame& frame, const Prepared& scene, const std::string& outputs);
  void draw_fur(const FurDrawing& drawing);
  Status draw_light(const FurFrame& frame, const Prepared& scene);
  /// Prepares and draws the light of a part, and waits for it.
  Result<Prepared> draw_part(const FurFrame& frame, const std::optional<Area>& part, DrawTimes& times);
  /// The light of the frame, or of its crop, at once.
  Result<Prepared> draw_whole(const FurFrame& frame, DrawTimes& times);
  /// The same in pieces where there is a pause. The whole, as it was prepared.
  Result<Prepared> draw_in_pieces(const FurFrame& frame, const Pause& pause, DrawTimes& times);
  /// By the fur in them: a small frame is one piece.
  Pieces pieces_of(const FurFrame& frame);
  Prepared prepare_whole(const FurFrame& frame, DrawTimes& times);
  bool let_in(const Pause& pause);  // whether to go on
  Status draw_sorted(const FurFrame& frame, const Prepared& scene);
  void draw_beside_light(const FurFrame& frame, const Prepared& scene, const AovTarget& target);
  /// Without a texture for null.
  RenderTarget overlay_target(const FloatImage* overlay) const;
  struct PictureFormat {
    GLenum target, type;
    int largest;  // of a channel
  };
  template <class Picture>
  Result<Picture> draw_picture(const FurFrame& frame, const FloatImage* overlay, const PictureFormat& format,
                               DrawTimes* times, const Pause& pause);
  /// The picture of the light that was drawn.
  Status finish_light(const FurFrame& frame, const FloatImage* overlay, int largest, DrawTimes& times);
  Result<std::vector<FloatImage>> gather_aovs(const FurFrame& frame, const Prepared& scene, std::span<const Aov> aovs,
                                              DrawTimes& times);
  Result<FloatImage> draw_aov(const FurFrame& frame, const Prepared& scene, Aov aov, const AovTarget* target);
  template <class Picture>
  Result<Picture> read_back(const RenderTarget& picture, GLenum type);

  const Gl& gl_;
  CoatSource coat_source_;
  FurPass fur_;
  GuardHairsPass guard_hairs_;
  CurvesPass curves_;
  ShadowMaps shadows_;
  GroundPass ground_;
  EyePass eyes_;
  AovsPass aovs_;
  ResolvePass resolve_;
  SortedPass sorted_;
  std::map<std::uint64_t, ModelBuffers> models_;
  std::list<CoatTextures> coats_;  // most recently used first
  PatternTextures pattern_;
  TuftTextures tufts_;
  PaintTextures paint_;
  ScatteringTextures scattering_;
  Buffer frame_block_, skin_block_;
  FragmentCounter fragments_;
  struct Targets {
    RenderTarget drawn, picture;  // light, the finished picture
  };
  Targets targets_;  // kept for the next frame of that size
};

}  // namespace pelage
