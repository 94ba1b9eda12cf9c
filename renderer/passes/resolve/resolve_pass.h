// From light to a picture: size, exposure, tone map, background and sRGB.
#pragma once

#include <string>

#include "renderer/gl/program.h"
#include "renderer/gl/render_target.h"
#include "renderer/input/fur_scene.h"

namespace pelage {

class ResolvePass {
 public:
  explicit ResolvePass(const Gl& gl);

  std::string failure() const { return program_.log(); }

  /// `drawn` has one sample and holds premultiplied linear light; `picture` is 8-bit RGBA of the asked size.
  void draw(const Gl& gl, const FurFrame& frame, const RenderTarget& drawn, const RenderTarget& picture);

 private:
  Program program_;
  VertexArray nothing_;
};

}  // namespace pelage
