// The slices of a coat on the GPU.
#pragma once

#include "renderer/coat/slices.h"
#include "renderer/gl/handles.h"
#include "renderer/upload/model_buffers.h"

namespace pelage {

class CoatTextures {
 public:
  CoatTextures(const Gl& gl, const Coat& coat, UploadCount& count);

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

}  // namespace pelage
