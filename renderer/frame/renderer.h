// Frames: the fixed, ordered list of passes, and the GPU copies of models and coats that they read.
#pragma once

#include <cstdint>
#include <list>
#include <map>
#include <memory>

#include "protocol/base/status.h"
#include "protocol/commands/answers.h"
#include "renderer/frame/shadow_maps.h"
#include "renderer/gl/fragment_counter.h"
#include "renderer/gl/render_target.h"
#include "renderer/image/image.h"
#include "renderer/input/fur_scene.h"
#include "renderer/passes/eye/eye_pass.h"
#include "renderer/passes/fur/fur_pass.h"
#include "renderer/passes/ground/ground_pass.h"
#include "renderer/passes/resolve/resolve_pass.h"
#include "renderer/upload/coat_textures.h"
#include "renderer/upload/model_buffers.h"
#include "renderer/upload/pattern_textures.h"
#include "renderer/upload/scattering_textures.h"

namespace pelage {

/// Milliseconds of a frame's stages, and what it asked of the GL.
struct DrawTimes {
  double shadow = 0, draw = 0, read = 0;
  FrameCounters counters;
};

/// Belongs to the thread and the context that it was made on.
class Renderer {
 public:
  /// Fails (unavailable) when a program cannot be built.
  static Result<std::unique_ptr<Renderer>> create(const Gl& gl);

  bool has(std::uint64_t model) const { return models_.contains(model); }
  /// Sends a model that the renderer does not have yet, with its fields.
  UploadCount add(const FurModel& model, const FurFields& fields);
  /// Sends the dirty ranges of a model that it has.
  UploadCount update(std::uint64_t model, const FurFields& fields);

  /// Draws a model that it has. Fails with unavailable when the GL does not answer within a minute,
  /// and with too_large when there is no memory for the size.
  Result<Image> draw(const FurFrame& frame, DrawTimes* times = nullptr);

  void forget(std::uint64_t model);

 private:
  explicit Renderer(const Gl& gl);
  Status programs() const;  // whether all programs so far were built
  Status prepare_targets(const FurFrame& frame);
  const CoatTextures& textures_of(const Coat& coat);
  void draw_scene(const FurFrame& frame, const CoatTextures& coat, ModelBuffers& model, DrawTimes& times);
  Status finish() const;  // waits for the GL
  FrameCounters take_counters() const;
  Result<Image> read_back(const FurFrame& frame);

  const Gl& gl_;
  FurPass fur_;
  ShadowMaps shadows_;
  GroundPass ground_;
  EyePass eyes_;
  ResolvePass resolve_;
  std::map<std::uint64_t, ModelBuffers> models_;
  std::list<CoatTextures> coats_;  // most recently used first
  PatternTextures pattern_;
  ScatteringTextures scattering_;
  Buffer frame_block_;
  FragmentCounter fragments_;
  RenderTarget drawn_, single_, picture_;
};

}  // namespace pelage
