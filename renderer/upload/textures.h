// GPU textures of coats, paint, tufts, patterns and scattering, and volume textures around a surface.
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

/// Returns an RGBA8 texture with linear filtering, clamped at its edges.
Texture volume_texture(const Gl& gl, const SurfaceVolume& volume);

// The slices of a coat on the GPU.

class CoatTextures {
 public:
  /// `slices`: those baked from `coat`.
  CoatTextures(const Gl& gl, const Coat& coat, const Slices& slices, UploadCount& count);

  const Coat& coat() const { return coat_; }
  /// Returns the slices without their texels: scales and depths.
  const Slices& slices() const { return slices_; }
  GLuint shapes() const { return shapes_.id(); }
  GLuint colours() const { return colours_.id(); }

 private:
  Coat coat_;
  Slices slices_;
  Texture shapes_, colours_;
};

// Painted fields on a coat.

/// The data of a coat that shaders need to draw paint: PaintBlock and the clump map. Both are rebuilt when the coat's
/// clumps change.
class PaintTextures {
 public:
  explicit PaintTextures(const Gl& gl) : uniforms_(gl) {}

  /// Binds PaintBlock (renderer/shaders/paint.glsl) to binding 6 and the clump map to texture unit 15.
  void prepare(const Gl& gl, const Coat& coat);

 private:
  Buffer uniforms_;
  Texture clumps_;
  std::optional<Coat> coat_;
};

// A coat's tufts on a model.

/// Rebuilt when the model or the tufts change; caches one model.
class TuftTextures {
 public:
  explicit TuftTextures(const Gl& gl) : uniforms_(gl) {}

  /// Binds the uniform block to binding 7 and the volume to texture unit 13.
  void prepare(const Gl& gl, std::uint64_t model_id, const Tufts& tufts, const ModelBuffers& model);

 private:
  void send(const Gl& gl, const Tufts& tufts, const ModelBuffers& model);

  Buffer uniforms_;
  Texture volume_;
  std::uint64_t model_ = 0;
  std::optional<Tufts> tufts_;
};

// A coat's pattern on a model: the volume of its colour weights, and the variation at the vertices.

/// Rebuilt when the model, the pattern, its variation or the colours change; caches one model.
class PatternTextures {
 public:
  explicit PatternTextures(const Gl& gl) : uniforms_(gl) {}

  /// Binds the uniform block to binding 1 and the volume to texture unit 8.
  void prepare(const Gl& gl, std::uint64_t model_id, const Coat& coat, ModelBuffers& model);

 private:
  void send_volume(const Gl& gl, const PatternBlock& block, const ModelBuffers& model);

  Buffer uniforms_;
  Texture volume_;
  std::uint64_t model_ = 0;
  std::optional<PatternBlock> block_;
};

// The GPU data of the look's shading model: its constants, and a table for the fibre models.

/// Rebuilt when the look or the coat's wetness changes.
class ScatteringTextures {
 public:
  explicit ScatteringTextures(const Gl& gl) : block_(gl) {}

  /// Binds the uniform block to binding 3 and the table, if there is one, to texture unit 3.
  void prepare(const Gl& gl, const FurFrame& frame);

 private:
  Buffer block_;
  Texture table_;
  std::optional<Look> look_;
};

}  // namespace pelage
