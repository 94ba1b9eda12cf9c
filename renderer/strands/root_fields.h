// The fields at a strand's root, and the table of lean curves by inclination and height (base/lean_curve.h). The table
// is needed because strands evaluate the curve too often to compute it each time.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "protocol/commands/coat.h"
#include "renderer/input/fur_scene.h"
#include "renderer/pattern/pattern.h"
#include "renderer/pattern/rest_pose.h"
#include "renderer/shaders/constants.h"
#include "renderer/skin/fur_vertex.h"

namespace pelage {

/// A position (across, up) on the lean curve of a strand of length 1, and its derivative by the height.
struct LeanKnot {
  glm::vec2 position{0}, slope{0};
};

/// Knots at the heights i / lean_cells.
using LeanRow = std::array<LeanKnot, lean_cells + 1>;

class LeanTable {
 public:
  LeanTable(LeanCurve curve, double root_share);

  /// Returns the row for an inclination in [0, 1]. Cubic interpolation between its knots deviates from the curve by
  /// less than 1e-5 of its length.
  LeanRow row(float inclination) const;
  /// Returns knot k of that row.
  LeanKnot knot(float inclination, std::size_t k) const;
  /// Returns the rows for evenly spaced inclinations from 0 to 1; rows in between are interpolated.
  std::span<const LeanRow> rows() const { return rows_; }

 private:
  std::vector<LeanRow> rows_;
};

// The surface fields at a strand's root, as renderer/shells/fur/fur_vertex.glsl passes them to fragments: evaluated at
// the corners of a triangle and interpolated.

/// Returns the fields of all vertices.
std::vector<FurVertex> fur_vertices(const FurModel& model, const FurFields& fields);

/// The fields at a root.
struct RootFields {
  glm::vec3 position{0};
  glm::vec3 normal{0, 1, 0}, tile_u{1, 0, 0}, tile_v{0, 0, 1};  // orthonormal
  RestPosePoint rest;                                           // position in the rest pose, for patterns and tufts
  float length = 0;                                             // length of the fur, sizes, >= 0
  float width = 1, wetness = 0, curl = 0, clump = 0;
  glm::vec4 root_paint{0}, tip_paint{0};
  glm::vec2 image_uv{0};
  glm::vec3 colour{1};
  int image = -1;
};

/// Returns the fields at a corner of a triangle, except those that only strands need: axes of the tile, curl and clump.
RootFields corner_fields(const FurModel& model, std::span<const FurVertex> vertices, std::uint32_t index, int corner);

/// The lean of the fur at a corner of a triangle.
struct CornerLean {
  glm::vec3 normal{0, 1, 0};  // unit
  float length = 0;           // length of the fur, sizes
  glm::vec3 direction{0};     // direction along the skin, unit
  float inclination = 0;      // [0, 1]
};
/// Returns the lean at a corner. `pattern` is null where length and lean do not change with the position.
CornerLean corner_lean(const FurVertex& vertex, glm::vec3 rest_position, glm::vec3 normal, glm::vec3 tangent,
                       const PatternBlock* pattern);

/// The lean of the fur at a corner before and after wind or body moves it.
struct CornerBend {
  CornerLean still, moved;
};
/// The bend at each corner of a triangle.
using TriangleBend = std::array<CornerBend, 3>;

/// The lean curves of the fur on a triangle, interpolated between those at its corners.
class LeanCurves {
 public:
  void set(int corner, const LeanTable& leans, const CornerLean& lean);
  /// Returns the offset from the root at the height s in [0, 1] of the fur, sizes. `share`: barycentric coordinates.
  glm::vec3 at(glm::vec3 share, float s) const;
  /// Returns the difference of these curves and `other`.
  LeanCurves less(const LeanCurves& other) const;

 private:
  struct Corner {
    std::array<glm::vec3, lean_cells + 1> curve, slope;
  };
  std::array<Corner, 3> corners_;
};

/// A triangle of furred skin with the data that its strands share. `share` is always barycentric coordinates.
class FurTriangle {
 public:
  /// `pattern` is null where length and lean do not change with the position.
  FurTriangle(const FurModel& model, std::span<const FurVertex> vertices, std::uint32_t index, const LeanTable& leans,
              const PatternBlock* pattern);

  /// Shares of the strands that grow, in [0, 1]: by weight and length, and by density.
  float grown(glm::vec3 share) const { return glm::dot(share, grown_); }
  float density(glm::vec3 share) const { return glm::dot(share, density_); }

  glm::vec3 position(glm::vec3 share) const;
  glm::vec3 rest_position(glm::vec3 share) const;
  RootFields fields(glm::vec3 share) const;
  const LeanCurves& curves() const { return curves_; }

 private:
  struct Corner {
    glm::vec3 position, normal, rest_position, rest_normal;
    FurVertex fur;
    FurCorner corner;
  };
  std::array<Corner, 3> corners_;
  LeanCurves curves_;
  glm::vec3 grown_, density_;  // for each corner
  glm::mat3 rotation_{1};      // rotation from the rest pose
};

}  // namespace pelage
