// Where the fur that stands out against the background grows: edges that carry fins, and the roots of guard hairs. Both
// are found once for a model and chosen for each view.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "renderer/gl/handles.h"
#include "renderer/gl/program.h"
#include "renderer/input/fur_scene.h"
#include "renderer/passes/fur/fur_pass.h"

namespace pelage {

/// Render vertices of a model, and the model's own vertex of each. A triangle of the surface may come as several
/// pieces.
struct StripMesh {
  std::span<const glm::vec3> positions, normals;
  std::span<const glm::uvec3> triangles;
  std::span<const std::uint32_t> welded;
};

/// An edge of the surface. fin.vert mirrors it.
struct FinEdge {
  glm::uvec2 ends{0};  // render vertices of one piece
  float width = 0;     // sizes: of the strip of surface that it stands for
  float padding = 0;
};
static_assert(sizeof(FinEdge) == 16);

/// The root of a guard hair on a triangle. hair.vert mirrors it.
struct HairRoot {
  glm::uvec3 corners{0};   // render vertices
  std::uint32_t bits = 0;  // random
  glm::vec3 weights{0};    // of the corners, sum 1
  float padding = 0;
};
static_assert(sizeof(HairRoot) == 32);

/// The first piece of each triangle of the surface.
std::vector<glm::uvec3> surface_triangles(const StripMesh& mesh);

/// Every edge of the surface once, in the order of the model's vertices.
std::vector<FinEdge> list_edges(const StripMesh& mesh);

/// Roots spread evenly over the surface's area; deterministic. Empty for a surface without area.
std::vector<HairRoot> scatter_hairs(const StripMesh& mesh, int count);

/// What is front-facing by less than these cosines is drawn, fading in from the limit on. The shaders hold the same.
inline constexpr float fin_limit = 0.15f, hair_limit = 0.6f;

/// What a view shows, far things first. The first `back-facing` stand on surface back-facing.
template <class Strip>
struct ShownStrips {
  std::vector<Strip> strips;
  std::size_t back_facing = 0;
};
ShownStrips<FinEdge> shown_fins(const StripMesh& mesh, std::span<const FinEdge> edges, glm::vec3 viewpoint);
ShownStrips<HairRoot> shown_hairs(const StripMesh& mesh, std::span<const HairRoot> roots, glm::vec3 viewpoint);

// What makes the silhouette of fur look like fur: fins on edges seen from the side, and guard hairs as ribbons.

/// Reads a model's buffers and a coat's textures, writes premultiplied linear light (and the depth of guard hairs).
/// Edges and roots are kept for one model, the side view for one coat; both are made when a frame first asks for them.
class FinsPass {
 public:
  explicit FinsPass(const Gl& gl) : array_(gl), elements_(gl), strips_(gl) {}

  /// "" when the programs of all variants so far were built.
  std::string failure() const { return failure_; }

  /// Fins near the silhouette whose edges have their middle in `range`, from far to near. Between a part's fur
  /// back-facing from the eye and its fur that faces it: what stands beyond the silhouette has only fins in it, and on
  /// the body fur covers them. The frame's block is bound.
  void draw_fins(const Gl& gl, const FurFrame& frame, const FurDrawing& drawing, const DepthRange& range);

  /// Guard hairs near the silhouette, after all other fur, in four passes (draw_four_passes), or at once where
  /// fragments are sorted.
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
    std::size_t back_facing, count;
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
