// AOVs: the target that they are drawn into, and the passes that draw them.
//
// Where shaders with AOVS write what a frame keeps beside colour.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "protocol/commands/frame.h"
#include "renderer/gl/handles.h"
#include "renderer/gl/program.h"
#include "renderer/passes/curves/curves_pass.h"
#include "renderer/passes/eye/eye_pass.h"
#include "renderer/passes/fur/fur_pass.h"
#include "renderer/passes/guard_hairs/guard_hairs_pass.h"

namespace pelage {

/// RGBA32F textures for the AOVs that are asked for, and none for the others, with one depth buffer.
class AovTarget {
 public:
  /// Beauty, alpha and depth have no texture here.
  AovTarget(const Gl& gl, std::span<const Aov> aovs, int width, int height);

  bool complete() const { return complete_; }
  GLuint framebuffer() const { return framebuffer_.id(); }
  int width() const { return width_; }
  int height() const { return height_; }
  /// Of an AOV that was asked for.
  GLuint texture(Aov aov) const;
  /// Whether an AOV has a texture here at all.
  static bool holds(Aov aov);
  void clear(const Gl& gl) const;

 private:
  static constexpr std::size_t places = 8;  // colour is the first; see renderer/shaders/aovs.glsl

  int width_, height_;
  bool complete_ = false;
  Framebuffer framebuffer_;
  std::array<Texture, places> textures_;
  Renderbuffer depth_;
};

// What an EXR holds beside colour: drawn again, only when asked for.

/// The passes that draw what a frame shows of a model.
struct BodyPasses {
  FurPass& fur;
  GuardHairsPass& guard_hairs;
  CurvesPass& curves;
  EyePass& eyes;
};

class AovsPass {
 public:
  explicit AovsPass(const Gl& gl) : nothing_(gl) {}

  /// "" when the programs so far were built.
  std::string failure() const { return failure_; }

  /// One over the distance along the view of what first brings the opacity over half into the first channel of
  /// `distance` (R32F with depth); 0 where there is none. `covered` (RG32F with depth, same size) is worked on. The
  /// frame's blocks and maps are bound.
  void draw_distance(const Gl& gl, const BodyPasses& body, const FurFrame& frame, const FurDrawing& drawing,
                     const RenderTarget& distance, const RenderTarget& covered);

  /// Brings an AOV to the picture's size (RGBA32F): colours, alpha and count as means; position, normal, tangent and
  /// shadow as Aov says, with the coverage in the fourth channel; depth as it is in the middle of the pixel.
  void gather(const Gl& gl, Aov aov, GLuint drawn, float scale, const RenderTarget& picture);

 private:
  struct DistancePrograms {
    DistancePrograms(const Gl& gl, const std::string& variant);
    Program skin, coverage, crossing;
  };
  const DistancePrograms& distance_programs(const Gl& gl, const std::string& variant);
  /// Depth of skin, dense fur and eyes, and one over their distance where that is asked for.
  void draw_solid(const Gl& gl, const BodyPasses& body, const FurFrame& frame, const FurDrawing& drawing,
                  const RenderTarget& target, bool distance);
  /// Draws something that may cover a pixel: its opacity, or one over its distance.
  using Piece = std::function<void(bool crossing)>;
  std::vector<Piece> pieces_inwards(const Gl& gl, const BodyPasses& body, const FurFrame& frame,
                                    const FurDrawing& drawing);

  // Made when first used.
  std::optional<Program> gather_;
  std::map<std::string, DistancePrograms> distance_;  // by variant
  std::string failure_;
  VertexArray nothing_;
};

}  // namespace pelage
