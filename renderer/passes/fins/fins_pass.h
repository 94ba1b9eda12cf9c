// What makes the outline of fur look like fur: fins on edges seen from the side, and guard hairs as ribbons.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "renderer/gl/handles.h"
#include "renderer/gl/program.h"
#include "renderer/input/fur_scene.h"
#include "renderer/passes/fins/strips.h"
#include "renderer/passes/fur/fur_pass.h"

namespace pelage {

/// Reads a model's buffers and a coat's textures, writes premultiplied linear light (and the depth of guard hairs).
/// Edges and roots are kept for one model, the side view for one coat; both are made when a frame first asks for them.
class FinsPass {
 public:
  explicit FinsPass(const Gl& gl) : array_(gl), elements_(gl), strips_(gl) {}

  /// "" when the programs of all variants so far were built.
  std::string failure() const { return failure_; }

  /// Fins near the outline whose edges have their middle in `range`, from far to near. Between a part's fur turned away
  /// from the eye and its fur that faces it: what stands beyond the outline has only fins in it, and on the body fur covers
  /// them. The frame's block is bound.
  void draw_fins(const Gl& gl, const FurFrame& frame, const FurDrawing& drawing, const DepthRange& range);

  /// Guard hairs near the outline, after all other fur, in four passes (draw_four_passes), or at once where fragments are sorted.
  void draw_hairs(const Gl& gl, const FurFrame& frame, const FurDrawing& drawing);

  /// The same fins and hairs once, with whatever blending and depth is set: for variants that write something other
  /// than light.
  void draw_plain_fins(const Gl& gl, const FurFrame& frame, const FurDrawing& drawing, const DepthRange& range);
  void draw_plain_hairs(const Gl& gl, const FurFrame& frame, const FurDrawing& drawing);

 private:
  struct Programs {
    Programs(const Gl& gl, const std::string& defines);
    Program fin, hair;
  };
  /// What is known of one model.
  struct Geometry {
    std::uint64_t model = 0;
    std::optional<std::vector<FinEdge>> edges;
    std::vector<HairRoot> roots;
    int hair_count = 0;
  };

  const Programs& programs_of(const Gl& gl, const std::string& variant);
  Geometry& geometry_of(std::uint64_t model);
  void send_side_view(const Gl& gl, const Coat& coat);
  void bind(const Gl& gl, const FurDrawing& drawing) const;
  void set_hair(const Program& hair, const Coat& coat) const;
  struct BoundHairs {
    const Program& program;
    std::size_t averted, count;
  };
  BoundHairs bind_hairs(const Gl& gl, const FurFrame& frame, const FurDrawing& drawing);

  VertexArray array_;
  Buffer elements_, strips_;
  Texture side_view_;
  std::optional<Coat> side_view_coat_;
  Geometry geometry_;
  std::map<std::string, Programs> programs_;  // by variant, made when first used
  std::string failure_;
};

}  // namespace pelage
