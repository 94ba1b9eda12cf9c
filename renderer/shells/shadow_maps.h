// The shadow maps of a frame's lights, cached until a light, the fields, the coat or the resolution changes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "renderer/gl/handles.h"
#include "renderer/input/fur_scene.h"
#include "renderer/shells/fur/fur_pass.h"
#include "renderer/shells/scene_shadow/scene_shadow_pass.h"
#include "renderer/shells/shell_shadow/shell_shadow_pass.h"
#include "renderer/upload/blocks.h"
#include "renderer/upload/model_buffers.h"
#include "renderer/upload/textures.h"

namespace pelage {

class ShadowMaps {
 public:
  explicit ShadowMaps(const Gl& gl);

  /// "" when the programs so far were built.
  std::string failure() const { return shells_.failure() + scene_.failure(); }

  /// Returns whether a frame has shadows from maps at all.
  static bool wanted(const FurFrame& frame);

  /// Draws the maps unless the cached ones fit. Returns whether it drew. `block` is the frame's own, the drawing's
  /// variant says what shapes the fur (PATTERN, TUFTS), and what that reads is bound. Leaves the maps bound to texture
  /// units 4 to 6, and the block to binding 2.
  bool prepare(const Gl& gl, const FurFrame& frame, const FrameBlock& block, const FurDrawing& drawing);

 private:
  struct Key {
    std::uint64_t model = 0, version = 0;
    Coat coat;
    std::vector<FurLight> lights;
    int resolution = 0;
    bool operator==(const Key&) const = default;
  };
  struct Counts {
    int shells = 0, casts = 0;  // lights with shell maps, lights with any map
  };
  Counts place_slots(const FurFrame& frame, float radius, std::vector<LightView>& views);
  void make_textures(const Gl& gl, const Counts& counts, int resolution);
  void see_from(const Gl& gl, const FrameBlock& block, const LightView& view, int resolution);
  void draw_maps(const Gl& gl, const FurFrame& frame, const FrameBlock& block, const std::vector<LightView>& views,
                 const FurDrawing& drawing);
  void bind(const Gl& gl) const;

  ShellShadowPass shells_;
  SceneShadowPass scene_;
  Buffer view_block_, shadow_block_;
  ShadowBlock slots_;
  Texture shell_maps_, depth_, width_;
  Key key_;
};

}  // namespace pelage
