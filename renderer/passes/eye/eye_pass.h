// Eyes, between the skin and the fur.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "renderer/eye/optics.h"
#include "renderer/gl/program.h"
#include "renderer/input/fur_scene.h"

namespace pelage {

/// Ray traces each eye inside a box, in premultiplied linear light and reversed depth. Its textures are made when the
/// first eye is drawn, and caustics once for each shape of eye.
class EyePass {
 public:
  explicit EyePass(const Gl& gl);

  /// "" when the programs of all variants so far were built.
  std::string failure() const { return failure_; }

  /// Into the bound target. Expects the frame's uniform block at binding 0 and depth testing as the fur pass sets it
  /// up; leaves a vertex array, a program and textures of its own bound. The frame has 1 to 8 eyes. The #define lines
  /// of `outputs` say what is written: "" light, AOVS the AOVs beside it, COVERING one over the distance of what
  /// covers half of a pixel.
  void draw(const Gl& gl, const FurFrame& frame, const std::string& outputs = {});

 private:
  struct Cached {
    std::optional<EyeShape> shape;
    std::uint64_t used = 0;  // number of the draw that needed it last
  };

  const Program& program_of(const Gl& gl, const std::string& outputs);
  void make_textures(const Gl& gl);
  int caustics_of(const Gl& gl, const EyeShape& shape);  // first array index

  std::map<std::string, Program> programs_;  // by outputs, made when first used
  std::string failure_;
  VertexArray nothing_;
  Buffer block_;
  Texture tissues_, caustics_;
  std::vector<Cached> cache_;  // shapes whose caustics the texture holds
  std::uint64_t draws_ = 0;
};

}  // namespace pelage
