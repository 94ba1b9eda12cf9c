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
  /// A part's fur that is back-facing, outside in.
  void draw_back_facing(const Gl& gl, const FurDrawing& drawing, const ModelBuffers::DepthPart& part);
  /// A part's fur that is front-facing, inside out. What is drawn between the two lies behind it.
  void draw_facing(const Gl& gl, const FurDrawing& drawing, const ModelBuffers::DepthPart& part);
  /// Depth of the skin and of dense fur, no colour: what hides fur that lies behind.
  void draw_depth(const Gl& gl, const FurDrawing& drawing);

  /// One of `shells` shells: how often they may be halved, texture steps in a slab, the triangles, from which side of
  /// the slab the ray comes (1 or -1), and what of it is drawn.
  struct Shell {
    int shell, shells, max_lod, steps;
    ModelBuffers::DrawList list;
    int side;
    DepthRange range{};
  };
  /// In the order of blending: back-facing outside in; facing inside out.
  static std::vector<Shell> back_facing_shells(const Knobs& knobs, const ModelBuffers::DepthPart& part);
  static std::vector<Shell> facing_shells(const Knobs& knobs, const ModelBuffers::DepthPart& part);
  /// With a program of fur_vertex.glsl and slab.glsl, in use.
  static void draw_shell(const Gl& gl, const Program& program, const Shell& shell);
  static void bind(const Gl& gl, const FurDrawing& drawing);

 private:
  /// The programs that shade: a scene pays only for the variant that it needs.
  struct Shading {
    Shading(const Gl& gl, const std::string& defines, bool at_vertices);
    Program skin, solid, fur;
  };
  void draw_fur(const Gl& gl, const FurDrawing& drawing, const std::vector<Shell>& shells);

  const Program& skin_of(const Gl& gl, const std::string& defines);
  const Shading& shading_of(const Gl& gl, const FurDrawing& drawing);
  /// A variant has one shading model: at_vertices that of the baseline.
  const Shading& shading_of(const Gl& gl, const std::string& variant, bool at_vertices);

  std::map<std::string, Shading> shadings_;  // by variant, made when first used
  std::map<std::string, Program> skins_;     // beside those of the shadings, by all of their defines
  std::string failure_;
};

}  // namespace pelage
