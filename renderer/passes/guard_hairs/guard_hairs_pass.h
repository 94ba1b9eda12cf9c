// Guard hairs: single hairs that stand out of the fur against the background, as ribbons. Their roots are found once
// for a model and chosen for each view.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "renderer/curves/guard_hairs.h"
#include "renderer/gl/handles.h"
#include "renderer/gl/program.h"
#include "renderer/input/fur_scene.h"
#include "renderer/passes/fur/fur_pass.h"

namespace pelage {

/// Reads a model's buffers and a coat's textures, writes premultiplied linear light and depth. Roots are kept for one
/// model, and made when a frame first asks for them.
class GuardHairsPass {
 public:
  explicit GuardHairsPass(const Gl& gl) : array_(gl), elements_(gl), roots_(gl) {}

  /// "" when the programs of all variants so far were built.
  std::string failure() const { return failure_; }

  /// Those near the silhouette, after all other fur, in four passes (draw_four_passes), or at once where fragments are
  /// sorted. The frame's block is bound.
  void draw(const Gl& gl, const FurFrame& frame, const FurDrawing& drawing);

  /// The same hairs once, with whatever blending and depth is set: for variants that write something other than light.
  void draw_plain(const Gl& gl, const FurFrame& frame, const FurDrawing& drawing);

 private:
  /// What is known of one model.
  struct Geometry {
    std::uint64_t model = 0;
    std::vector<HairRoot> roots;
    int count = 0;
  };

  const Program& program_of(const Gl& gl, const std::string& variant);
  void bind(const Gl& gl, const FurDrawing& drawing) const;
  struct BoundHairs {
    const Program& program;
    std::size_t back_facing, count;
  };
  BoundHairs bind_hairs(const Gl& gl, const FurFrame& frame, const FurDrawing& drawing);

  VertexArray array_;
  Buffer elements_, roots_;
  Geometry geometry_;
  std::map<std::string, Program> programs_;  // by variant, made when first used
  std::string failure_;
};

}  // namespace pelage
