// Guard hairs: single hairs that stand out of the fur against the background, as ribbons. Their roots are found once
// for a model and chosen for each view.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
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

/// Roots spread evenly over the surface's area; deterministic. Empty for a surface without area.
std::vector<HairRoot> scatter_hairs(const StripMesh& mesh, int count);

/// What faces the camera by less than this cosine is drawn, fading in from there on. hair.vert holds the same.
inline constexpr float hair_limit = 0.6f;

/// What a view shows, far things first. The first `back_facing` stand on skin that faces away.
struct ShownHairs {
  std::vector<HairRoot> roots;
  std::size_t back_facing = 0;
};
ShownHairs shown_hairs(const StripMesh& mesh, std::span<const HairRoot> roots, glm::vec3 viewpoint);

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
