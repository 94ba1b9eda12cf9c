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

  /// Binds a model and its coat, for both draws. `variant` below are the #define lines of what the frame uses; the
  /// target is bound and cleared, and so are the frame's block and what the variant reads.
  void bind(const Gl& gl, const ModelBuffers& model, const CoatTextures& coat) const;
  /// The skin, and the depth of dense fur.
  void draw_skin(const Gl& gl, const std::string& variant, const ModelBuffers::DrawLists& lists);
  /// Fur turned away from the eye, outside in; fur that faces it, inside out.
  void draw_fur(const Gl& gl, const std::string& variant, const Knobs& knobs, const ModelBuffers::DrawLists& lists);

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
  void draw_layer(const Gl& gl, const Program& program, const ModelBuffers::DrawList& list, const Layer& layer,
                  int side) const;

  const Shading& shading_of(const Gl& gl, const std::string& variant);

  std::map<std::string, Shading> shadings_;  // by variant, made when first used
  std::string failure_;
};

}  // namespace pelage
