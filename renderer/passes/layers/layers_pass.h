// What an EXR holds beside colour: drawn again, only when asked for.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>

#include "renderer/gl/program.h"
#include "renderer/gl/render_target.h"
#include "renderer/passes/fur/fur_pass.h"
#include "renderer/passes/layers/layer_target.h"

namespace pelage {

class LayersPass {
 public:
  explicit LayersPass(const Gl& gl) : nothing_(gl) {}

  /// "" when the programs so far were built.
  std::string failure() const { return failure_; }

  /// Draws the layers that a LayerTarget holds. The frame's blocks and maps are bound.
  void draw(const Gl& gl, FurPass& fur, const FurDrawing& drawing, const LayerTarget& target);

  /// One over the distance along the view of the first fur or skin over half opacity into the first channel of
  /// `distance` (R32F with depth); 0 where there is none. `covered` (RG32F with depth, same size) is worked on.
  void draw_distance(const Gl& gl, FurPass& fur, const FurDrawing& drawing, const RenderTarget& distance,
                     const RenderTarget& covered);

  /// Brings a layer to the picture's size (RGBA32F): colours, alpha and count as means; position, normal, tangent and
  /// shadow as FrameLayer says, with the coverage in the fourth channel; depth as it is in the middle of the pixel.
  void gather(const Gl& gl, FrameLayer layer, GLuint drawn, float scale, const RenderTarget& picture);

 private:
  struct DistancePrograms {
    DistancePrograms(const Gl& gl, const std::string& variant);
    Program skin, coverage, crossing;
  };
  const DistancePrograms& distance_programs(const Gl& gl, const std::string& variant);
  void draw_crossings(const Gl& gl, const DistancePrograms& with, const FurDrawing& drawing,
                      const RenderTarget& distance, const RenderTarget& covered) const;

  // Made when first used.
  std::optional<Program> gather_;
  std::map<std::string, DistancePrograms> distance_;  // by variant
  std::string failure_;
  VertexArray nothing_;
};

}  // namespace pelage
