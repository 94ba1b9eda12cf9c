// The skin with its undercoat, then the fur as shells.
#pragma once

#include <string>

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

  /// Clears the target and draws. Order: skin; depth of dense fur; fur turned away from the
  /// eye, outside in; fur that faces it, inside out.
  void draw(const Gl& gl, const FrameBlock& block, ModelBuffers& model, const CoatTextures& coat, const RenderTarget& target);

 private:
  void draw_shells(const Gl& gl, const Program& program, const ModelBuffers::DrawLists& lists, int shells,
                   float push) const;

  Program skin_, solid_, fur_;
  Buffer block_;
};

}  // namespace pelage
