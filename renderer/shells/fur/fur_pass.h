// Draws the skin with its undercoat, then the fur as shells.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "renderer/gl/handles.h"
#include "renderer/gl/program.h"
#include "renderer/input/fur_scene.h"
#include "renderer/upload/blocks.h"
#include "renderer/upload/model_buffers.h"
#include "renderer/upload/textures.h"

namespace pelage {

/// What every pass over the fur reads: the frame, its model and coat, and the variant of the shaders.
struct FurDrawing {
  const FurFrame& frame;
  std::string variant;  // #define lines of what the frame uses; SHADOW_MAPS: the maps have to be bound
  const ModelBuffers& model;
  const ModelBuffers::DrawLists& lists;  // triangles to draw for the frame's view
  const CoatTextures& coat;

  /// Returns the same drawing with more #define lines.
  FurDrawing with(const std::string& defines) const { return {frame, variant + defines, model, lists, coat}; }
};

/// Writes premultiplied linear light and reversed depth. Before each draw, the caller binds and clears the target, and
/// binds the frame's block and what the variant reads.
class FurPass {
 public:
  explicit FurPass(const Gl& gl);

  /// Returns why programs could not be built; "" if those of all variants so far were.
  std::string failure() const { return failure_; }

  void draw_skin(const Gl& gl, const FurDrawing& drawing);
  /// Writes the depth of dense fur, without colour, right after the skin. It hides fur that lies well behind; for
  /// drawings whose fragments are not sorted.
  void draw_dense(const Gl& gl, const FurDrawing& drawing);
  /// Draws the shells of back-facing fur from the outside in, then those of front-facing fur from the inside out.
  void draw_shells(const Gl& gl, const FurDrawing& drawing);
  /// Binds the model's vertex array, and the textures of the coat and the skin.
  static void bind(const Gl& gl, const FurDrawing& drawing);

 private:
  /// The programs of one variant. `at_vertices`: light is computed at the vertices.
  struct Shading {
    Shading(const Gl& gl, const std::string& defines, bool at_vertices);
    Program skin, solid, fur;
  };

  const Shading& shading_of(const Gl& gl, const FurDrawing& drawing);
  /// A variant has one shading model; `at_vertices` is the baseline, ShadingModel::lengyel.
  const Shading& shading_of(const Gl& gl, const std::string& variant, bool at_vertices);

  std::map<std::string, Shading> shadings_;  // by variant, made when first used
  std::string failure_;
};

}  // namespace pelage
