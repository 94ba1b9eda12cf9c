// The shadow maps of a frame's lights, kept until a light, the fields, the coat or the resolution changes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "renderer/gl/handles.h"
#include "renderer/gl/render_target.h"
#include "renderer/input/fur_scene.h"
#include "renderer/passes/scene_shadow/scene_shadow_pass.h"
#include "renderer/passes/shell_shadow/shell_shadow_pass.h"
#include "renderer/upload/coat_textures.h"
#include "renderer/upload/frame_block.h"
#include "renderer/upload/model_buffers.h"
#include "renderer/upload/shadow_block.h"

namespace pelage {

class ShadowMaps {
 public:
  explicit ShadowMaps(const Gl& gl);

  std::string failure() const { return shells_.failure() + scene_.failure(); }

  /// Draws depth for other passes too.
  const SceneShadowPass& scene() const { return scene_; }

  /// Whether a frame has shadows from maps at all.
  static bool wanted(const FurFrame& frame);

  /// Makes the maps unless the kept ones serve; true when it drew. `block` is the frame's own. Leaves the maps bound
  /// to texture units 4 to 6 and the block to binding 2.
  bool prepare(const Gl& gl, const FurFrame& frame, const FrameBlock& block, const ModelBuffers& model,
               const CoatTextures& coat, const ModelBuffers::DrawLists& lists);

 private:
  struct Key {
    std::uint64_t model = 0, version = 0;
    Coat coat;
    std::vector<FurLight> lights;
    int resolution = 0;
    bool operator==(const Key&) const = default;
  };
  struct Counts {
    int layers = 0, casts = 0;  // lights with layer maps, lights with any map
  };
  Counts place_slots(const FurFrame& frame, float radius, std::vector<LightView>& views);
  void make_textures(const Gl& gl, const Counts& counts, int resolution);
  void draw_maps(const Gl& gl, const FrameBlock& block, const std::vector<LightView>& views,
                 const ModelBuffers::DrawList& triangles, int resolution);
  void bind(const Gl& gl) const;

  ShellShadowPass shells_;
  SceneShadowPass scene_;
  Buffer view_block_, shadow_block_;
  ShadowBlock slots_;
  Texture kept_, depth_, width_;
  Key key_;
};

}  // namespace pelage
