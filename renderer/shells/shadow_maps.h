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

  /// Returns why programs could not be built; "" if all were.
  std::string failure() const { return shells_.failure() + scene_.failure(); }

  /// Returns whether a frame has any shadow from maps.
  static bool wanted(const FurFrame& frame);

  /// Draws the maps unless the cached ones fit. Returns whether it drew. `block` is the frame's own. The drawing's
  /// variant has the #define lines of what shapes the fur (PATTERN, TUFTS), whose textures must be bound. Leaves the
  /// maps bound to texture units 4 to 6, and ShadowBlock to binding 2.
  bool prepare(const Gl& gl, const FurFrame& frame, const FrameBlock& block, const FurDrawing& drawing);

 private:
  /// What the cached maps were drawn for.
  struct Key {
    std::uint64_t model = 0, version = 0;
    Coat coat;
    std::vector<FurLight> lights;
    int resolution = 0;
    bool operator==(const Key&) const = default;
  };
  struct Counts {
    int shells = 0, casts = 0;  // number of lights with shell maps, and with any map
  };
  Counts place_slots(const FurFrame& frame, float radius, std::vector<LightView>& views);
  void make_textures(const Gl& gl, const Counts& counts, int resolution);
  /// Binds a frame block with the view of a light.
  void bind_light_view(const Gl& gl, const FrameBlock& block, const LightView& view, int resolution);
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
