// The skin with its undercoat, then the fur as shells.
#pragma once

#include <string>
#include <vector>

#include "renderer/gl/program.h"
#include "renderer/gl/render_target.h"
#include "renderer/upload/coat_textures.h"
#include "renderer/upload/frame_block.h"
#include "renderer/upload/model_buffers.h"

namespace pelage {

/// Reads a model's buffers and a coat's textures, writes premultiplied linear light and reversed depth.
class FurPass {
 public:
  explicit FurPass(const Gl& gl);

  /// "" when both programs were built.
  std::string failure() const { return solid_.log() + plain_.skin.log() + plain_.fur.log() + shadowed_.skin.log() + shadowed_.fur.log(); }

  /// Clears the target and draws. Order: skin; depth of dense fur; fur turned away from the
  /// eye, outside in; fur that faces it, inside out.
  /// `block` and `lists` are those of the frame's view; with `shadow_maps` the maps are bound.
  void draw(const Gl& gl, const FrameBlock& block, const Knobs& knobs, bool shadow_maps, const ModelBuffers& model,
            const ModelBuffers::DrawLists& lists, const CoatTextures& coat, const RenderTarget& target) const;

 private:
  /// One shell of one set of layers.
  struct Layer {
    int set, shell, shells, steps;
    double height() const { return (shell + 0.5) / shells; }
  };
  static std::vector<Layer> layers_of(const Knobs& knobs);  // of all sets, inside out
  /// The programs that shade: a scene pays only for the variant that it needs.
  struct Shading {
    Shading(const Gl& gl, const std::string& defines);
    Program skin, fur;
  };
  void draw_skin(const Gl& gl, const Program& skin, const ModelBuffers::DrawLists& lists) const;
  void draw_fur(const Gl& gl, const Program& fur, const ModelBuffers::DrawLists& lists, const Knobs& knobs) const;
  void draw_layer(const Gl& gl, const Program& program, const ModelBuffers::DrawList& list, const Layer& layer,
                  int side) const;

  Program solid_;
  Shading plain_, shadowed_;
  Buffer block_;
};

}  // namespace pelage
