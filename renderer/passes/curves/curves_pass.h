// Whiskers, lashes and brows: guided curves as ribbons that are front-facing.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "renderer/curves/curve_strips.h"
#include "renderer/gl/handles.h"
#include "renderer/gl/program.h"
#include "renderer/input/fur_scene.h"
#include "renderer/upload/blocks.h"

namespace pelage {

/// Writes premultiplied linear light and depth. What it needs is made when the first curve is drawn; curves are
/// evaluated and sent only when they differ from the last ones.
class CurvesPass {
 public:
  /// "" when the programs of all variants so far were built.
  std::string failure() const { return failure_; }

  /// After all fur, in four passes (draw_four_passes): skin, eyes and dense fur hide what lies behind them, and the fur
  /// that a root stands in hides it as much as it hides a guard hair. The frame's blocks, what the variant (#define
  /// lines) reads and the target are bound, and the frame has curves.
  void draw(const Gl& gl, const FurFrame& frame, const std::string& variant);

  /// All curves once, with whatever blending and depth is set: for variants that write something other than light.
  void draw_plain(const Gl& gl, const FurFrame& frame, const std::string& variant);

  /// What the curves of a frame let through on the way from a light, and the linear depth of the nearest in the fourth
  /// number, into a target of RGBA32F. The frame block of the light's view is bound.
  void draw_shadow(const Gl& gl, const FurFrame& frame, const LightView& light, const RenderTarget& target);

 private:
  const Program& program_of(const Gl& gl, const std::string& variant);
  void make_buffers(const Gl& gl);
  void send_strips(const Gl& gl, const std::vector<FurCurves>& curves);
  /// Sends and binds what programs of curve.vert read, for a view.
  CurveOrder bind(const Gl& gl, const FurFrame& frame, glm::vec3 viewpoint);

  VertexArray array_;
  Buffer elements_, points_, styles_, numbers_;
  std::vector<FurCurves> sent_;  // whose strips the buffers hold
  CurveStrips strips_;
  std::map<std::string, Program> programs_;  // by variant, made when first used
  std::optional<Program> shadow_;
  std::string failure_;
};

}  // namespace pelage
