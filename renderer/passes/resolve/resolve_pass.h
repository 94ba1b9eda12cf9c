// From light to a picture: size, exposure, tone map, background, sRGB and overlay.
#pragma once

#include <map>
#include <string>

#include "renderer/gl/handles.h"
#include "renderer/gl/program.h"
#include "renderer/input/fur_scene.h"

namespace pelage {

class ResolvePass {
 public:
  explicit ResolvePass(const Gl& gl);

  std::string failure() const { return failure_; }

  /// `drawn` has one sample and holds premultiplied linear light; `picture` is RGBA of the asked size, and `largest`
  /// the largest value of its channels (255 or 65535). Where the frame has an overlay, `overlay` is it: a texture of
  /// the picture's size, sRGB with straight alpha.
  void draw(const Gl& gl, const FurFrame& frame, const RenderTarget& drawn, const RenderTarget& picture, int largest,
            GLuint overlay);

 private:
  const Program& program_of(const Gl& gl, const FurFrame& frame);

  std::map<std::string, Program> programs_;  // by variant, made when first used
  std::string failure_;
  VertexArray nothing_;
};

}  // namespace pelage
