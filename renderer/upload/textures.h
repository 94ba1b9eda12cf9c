// A volume about a surface as a texture.
#pragma once

#include <optional>

#include "renderer/coat/clump.h"
#include "renderer/coat/slices.h"
#include "renderer/gl/handles.h"
#include "renderer/pattern/surface_volume.h"
#include "renderer/upload/model_buffers.h"

namespace pelage {

/// RGBA8, read linearly and clamped at its sides.
Texture volume_texture(const Gl& gl, const SurfaceVolume& volume);

// The slices of a coat on the GPU.

class CoatTextures {
 public:
  /// `slices` are those that were baked of the coat.
  CoatTextures(const Gl& gl, const Coat& coat, Slices slices, UploadCount& count);

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

/// Made anew when the coat's clumps change.
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

}  // namespace pelage
