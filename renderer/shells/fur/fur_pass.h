// The skin with its undercoat, then the fur as shells.
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

/// What is drawn of a frame: the parts that every pass over the fur needs.
struct FurDrawing {
  const FurFrame& frame;
  std::string variant;  // #define lines of what the frame uses (SHADOW_MAPS: the maps are bound)
  const ModelBuffers& model;
  const ModelBuffers::DrawLists& lists;  // of the frame's view
  const CoatTextures& coat;

  /// The same with more #define lines.
  FurDrawing with(const std::string& defines) const { return {frame, variant + defines, model, lists, coat}; }
};

/// Reads a model's buffers and a coat's textures, writes premultiplied linear light and reversed depth. Before each
/// draw the target is bound and cleared, and the frame's block and what the variant reads are bound.
class FurPass {
 public:
  explicit FurPass(const Gl& gl);

  /// "" when the programs of all variants so far were built.
  std::string failure() const { return failure_; }

  void draw_skin(const Gl& gl, const FurDrawing& drawing);
  /// Right after the skin: depth of dense fur, no colour. It hides fur that lies well behind where fragments are not
  /// sorted.
  void draw_dense(const Gl& gl, const FurDrawing& drawing);
  /// Draws the shells of back-facing fur from the outside in, then those of front-facing fur from the inside out.
  void draw_shells(const Gl& gl, const FurDrawing& drawing);
  static void bind(const Gl& gl, const FurDrawing& drawing);

 private:
  /// The programs that shade: a scene pays only for the variant that it needs.
  struct Shading {
    Shading(const Gl& gl, const std::string& defines, bool at_vertices);
    Program skin, solid, fur;
  };

  const Shading& shading_of(const Gl& gl, const FurDrawing& drawing);
  /// A variant has one shading model: at_vertices that of the baseline.
  const Shading& shading_of(const Gl& gl, const std::string& variant, bool at_vertices);

  std::map<std::string, Shading> shadings_;  // by variant, made when first used
  std::string failure_;
};

}  // namespace pelage
