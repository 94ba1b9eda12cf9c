// Painted fields on the GPU: nothing is made before a tool has touched one.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "renderer/gl/handles.h"
#include "renderer/input/fur_scene.h"

namespace pelage {

struct UploadCount;

/// Two buffers over the render vertices of a model, as renderer/shaders/paint_attributes.glsl
/// reads them: numbers (density, width, wetness, bare; curl, clump) and colours (root, tip; times their cover).
class PaintBuffers {
 public:
  explicit PaintBuffers(const Gl& gl) : numbers_(gl), colours_(gl) {}

  /// Makes room for what is painted, as attributes of the vertex array. True when other fields are touched than before:
  /// then all vertices are to be sent.
  bool prepare(const Gl& gl, const FurPaint& paint, GLuint vertex_array, std::size_t render_vertices);

  /// Sends the render vertices from `begin` on; `welded` has the model's vertex of each.
  void send(const Gl& gl, const FurPaint& paint, std::size_t begin, std::span<const std::uint32_t> welded,
            UploadCount& count) const;

  /// The #define lines of what is drawn: PAINT for numbers, PAINT_COLOUR for colours.
  std::string defines() const;
  std::size_t bytes(const Gl& gl) const {
    return gl.bytes_of_buffer(numbers_.id()) + gl.bytes_of_buffer(colours_.id());
  }
  bool changes_fur() const { return touched_.fur; }

 private:
  struct Touched {
    bool fur = false, colours = false;
    bool operator==(const Touched&) const = default;
  };

  Buffer numbers_, colours_;
  Touched touched_;
};

}  // namespace pelage
