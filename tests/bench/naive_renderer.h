// The naive renderer that frames are measured against: uniform shells from the inside out over all triangles, two
// trilinear array textures, light on every fragment, one sample per pixel, half floats.
#pragma once

#include "renderer/frame/renderer.h"
#include "renderer/upload/textures.h"
#include "tests/support/furred_model.h"

namespace pelage::bench {

class NaiveRenderer {
 public:
  NaiveRenderer(const Gl& gl, const testing::FurredModel& model, const FurFrame& frame);

  Image draw();

 private:
  const Gl& gl_;
  FurFrame frame_;
  CoatTextures coat_;
  ModelBuffers model_;
  Program skin_, shell_;
  ScatteringTextures scattering_;
  Buffer block_;
  RenderTarget drawn_;
};

}  // namespace pelage::bench
