// The textures of coats, paint, tufts, patterns and scattering, and volume textures about a surface.
#pragma once

#include <cstdint>
#include <optional>

#include "renderer/coat/slices.h"
#include "renderer/coat/strand_tile.h"
#include "renderer/gl/handles.h"
#include "renderer/input/fur_scene.h"
#include "renderer/pattern/pattern.h"
#include "renderer/pattern/surface_volume.h"
#include "renderer/pattern/tufts.h"
#include "renderer/upload/model_buffers.h"

namespace pelage {

/// RGBA8, read linearly and clamped at its sides.
Texture volume_texture(const Gl& gl, const SurfaceVolume& volume);

// The slices of a coat on the GPU.

class CoatTextures {
 public:
  /// `slices` are those that were baked of the coat.
  CoatTextures(const Gl& gl, const Coat& coat, const Slices& slices, UploadCount& count);

  const Coat& coat() const { return coat_; }
  /// Levels without their texels: scales and depths.
  const Slices& slices() const { return slices_; }
  GLuint shapes() const { return shapes_.id(); }
  GLuint colours() const { return colours_.id(); }

 private:
  Coat coat_;
  Slices slices_;
  Texture shapes_, colours_;
};

// What shaders must know of a coat to draw painted fields on it.

/// What shaders read of a coat to draw paint: PaintBlock and the map of clumps. Both are made again when the coat's
/// clumps change.
class PaintTextures {
 public:
  explicit PaintTextures(const Gl& gl) : uniforms_(gl) {}

  /// Leaves PaintBlock (renderer/shaders/paint.glsl) at binding 6 and the map of clumps at texture unit 15.
  void prepare(const Gl& gl, const Coat& coat);

 private:
  Buffer uniforms_;
  Texture clumps_;
  std::optional<Coat> coat_;
};

// A coat's tufts on a model.

/// Made anew when the model or the tufts change; kept for one model.
class TuftTextures {
 public:
  explicit TuftTextures(const Gl& gl) : uniforms_(gl) {}

  /// Leaves the uniform block at binding 7 and the volume at texture unit 13.
  void prepare(const Gl& gl, std::uint64_t model_id, const Tufts& tufts, const ModelBuffers& model);

 private:
  void send(const Gl& gl, const Tufts& tufts, const ModelBuffers& model);

  Buffer uniforms_;
  Texture volume_;
  std::uint64_t model_ = 0;
  std::optional<Tufts> tufts_;
};

// A coat's pattern on a model: the volume of its colours, and the slow changes at the vertices.

/// Made anew when the model, the pattern, its variation or the colours change; kept for one model.
class PatternTextures {
 public:
  explicit PatternTextures(const Gl& gl) : uniforms_(gl) {}

  /// Leaves the uniform block at binding 1 and the volume at texture unit 8.
  void prepare(const Gl& gl, std::uint64_t model_id, const Coat& coat, ModelBuffers& model);

 private:
  void send_volume(const Gl& gl, const PatternBlock& block, const ModelBuffers& model);

  Buffer uniforms_;
  Texture volume_;
  std::uint64_t model_ = 0;
  std::optional<PatternBlock> block_;
};

// What the look's shading model reads on the GPU: its numbers, and for the fibre models a table.

/// Made anew when the look or the coat's wetness changes.
class ScatteringTextures {
 public:
  explicit ScatteringTextures(const Gl& gl) : block_(gl) {}

  /// Leaves the uniform block at binding 3 and the table, where there is one, at texture unit 3.
  void prepare(const Gl& gl, const FurFrame& frame);

 private:
  Buffer block_;
  Texture table_;
  std::optional<Look> look_;
};

}  // namespace pelage
