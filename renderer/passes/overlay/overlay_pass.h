// Fields and costs over a frame, for inspection.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "renderer/gl/handles.h"
#include "renderer/gl/program.h"
#include "renderer/input/fur_scene.h"
#include "renderer/upload/model_buffers.h"

namespace pelage {

/// Fields lie on the skin: where only tips reach, the frame shows as it is.
class OverlayPass {
 public:
  explicit OverlayPass(const Gl& gl) : nothing_(gl) {}

  /// "" when the programs so far were built.
  std::string failure() const;

  /// A field of the model, not the count. Writes sRGB with straight alpha into a new target of the frame's size; the
  /// frame's block is bound.
  RenderTarget draw_field(const Gl& gl, const FurFrame& frame, const ModelBuffers& model,
                          const ModelBuffers::DrawList& triangles);
  /// FurFrame::difference, as draw_field.
  RenderTarget draw_difference(const Gl& gl, const FurFrame& frame, const ModelBuffers& model,
                               const ModelBuffers::DrawList& triangles);
  /// Whether an overlay is a map of a light and not a picture of the model.
  static bool is_map(Overlay overlay);
  /// A light's map: the first channel of a texture as grey, black at `ends[0]` and white at `ends[1]`, in the largest
  /// square of the frame, which it hides.
  RenderTarget draw_map(const Gl& gl, const FurFrame& frame, GLuint map, std::array<float, 2> ends);
  /// The count of shells: a texture with counts in its first channel, drawn at `scale` times the frame's size.
  RenderTarget draw_count(const Gl& gl, const FurFrame& frame, GLuint counts, float scale);

 private:
  struct Programs {
    explicit Programs(const Gl& gl);
    Program field, strokes, count, map;
  };
  const Programs& programs(const Gl& gl);
  /// A target for the skin, bound with the model's vertices; it may be incomplete.
  RenderTarget begin_skin(const Gl& gl, const FurFrame& frame, const ModelBuffers& model) const;
  void draw_whole(const Gl& gl, const RenderTarget& target, GLuint source) const;

  /// What a comparison needs beside the model.
  struct Comparison {
    explicit Comparison(const Gl& gl);
    Program program;
    Buffer shares;  // of render vertices
  };

  std::optional<Programs> programs_;      // made when first used
  std::optional<Comparison> comparison_;  // the same
  VertexArray nothing_;
};

}  // namespace pelage
