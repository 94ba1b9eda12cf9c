// Eyes, between the skin and the fur.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "renderer/eye/shape.h"
#include "renderer/gl/program.h"
#include "renderer/gl/render_target.h"
#include "renderer/input/fur_scene.h"

namespace pelage {

/// Ray traces each eye inside a box, in premultiplied linear light and reversed depth. Its textures are made when the
/// first eye is drawn, and caustics once for each shape of eye.
class EyePass {
 public:
  explicit EyePass(const Gl& gl);

  std::string failure() const { return program_.log(); }

  /// Expects the frame's uniform block at binding 0 and depth testing as the fur pass sets it up; leaves a vertex
  /// array, a program and textures of its own bound. The frame has 1 to 8 eyes.
  void draw(const Gl& gl, const FurFrame& frame, const RenderTarget& target);

 private:
  struct Kept {
    std::optional<EyeShape> shape;
    std::uint64_t used = 0;  // number of the draw that needed it last
  };

  void make_textures(const Gl& gl);
  int caustics_of(const Gl& gl, const EyeShape& shape);  // first layer

  Program program_;
  VertexArray nothing_;
  Buffer block_;
  Texture tissues_, caustics_;
  std::vector<Kept> kept_;  // shapes whose caustics the texture holds
  std::uint64_t draws_ = 0;
};

}  // namespace pelage
