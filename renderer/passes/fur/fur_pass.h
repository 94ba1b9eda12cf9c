// The skin with its undercoat, then the fur as shells.
#pragma once

#include <map>
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

  /// "" when the programs of all variants so far were built.
  std::string failure() const { return failure_; }

  /// Order: skin; depth of dense fur; fur turned away from the
  /// eye, outside in; fur that faces it, inside out.
  /// `variant` are the #define lines of what the frame uses (SHADOW_MAPS: the maps are bound; ENVIRONMENT); `lists` are those of
  /// the frame's view. The target is bound and cleared, the frame's block is bound.
  void draw(const Gl& gl, const Knobs& knobs, const std::string& variant, const ModelBuffers& model,
            const ModelBuffers::DrawLists& lists, const CoatTextures& coat);

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
    Program skin, solid, fur;
  };
  void draw_skin(const Gl& gl, const Shading& shading, const ModelBuffers::DrawLists& lists) const;
  void draw_fur(const Gl& gl, const Program& fur, const ModelBuffers::DrawLists& lists, const Knobs& knobs) const;
  void draw_layer(const Gl& gl, const Program& program, const ModelBuffers::DrawList& list, const Layer& layer,
                  int side) const;

  const Shading& shading_of(const Gl& gl, const std::string& variant);

  std::map<std::string, Shading> shadings_;  // by variant, made when first used
  std::string failure_;
};

}  // namespace pelage
