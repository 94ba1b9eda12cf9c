// The skin with its undercoat, then the fur as shells.
#pragma once

#include <functional>
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
  std::string failure() const { return skin_.log() + solid_.log() + fur_.log(); }

  /// Clears the target and draws. Order: skin; depth of dense fur; what `before_fur` draws, where it is given; fur turned
  /// away from the eye, outside in; fur that faces it, inside out.
  void draw(const Gl& gl, const FrameBlock& block, const Knobs& knobs, ModelBuffers& model, const CoatTextures& coat,
            const RenderTarget& target, const std::function<void()>& before_fur = {});

 private:
  /// One shell of one set of layers.
  struct Layer {
    int set, shell, shells, steps;
    double height() const { return (shell + 0.5) / shells; }
  };
  static std::vector<Layer> layers_of(const Knobs& knobs);  // of all sets, inside out
  static void bind(const Gl& gl, const ModelBuffers& model, const CoatTextures& coat);
  void draw_skin(const Gl& gl, const ModelBuffers::DrawLists& lists) const;
  void draw_fur(const Gl& gl, const ModelBuffers::DrawLists& lists, const Knobs& knobs) const;
  void draw_layer(const Gl& gl, const Program& program, const ModelBuffers::DrawList& list, const Layer& layer,
                  int side) const;

  Program skin_, solid_, fur_;
  Buffer block_;
};

}  // namespace pelage
