// The raw model that a parser makes from a file (polygons in double, not repaired), and the prepared Mesh.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "protocol/commands/answers.h"

namespace pelage {

inline bool is_finite(glm::dvec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// 8-bit sRGB colour with straight alpha, rows from the top, 4 * width * height bytes.
struct RawImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

struct RawMaterial {
  glm::vec3 base_colour{1};  // linear; multiplies the image and the vertex colours
  int image = -1;            // index in RawModel::images, -1 for none
  std::string name = {};     // the file's name for it; "" for none
};

/// In RawModel::corners: a reference to a vertex that the file does not have.
inline constexpr std::uint32_t no_position = 0xffffffff;

/// Maximum number of names in a report of something that was left out.
inline constexpr std::size_t named_losses = 8;

/// Polygons of a model after node transforms. Corners are listed face by face.
struct RawModel {
  bool is_32_bit = false;                    // true if the file's coordinates are 32-bit numbers
  std::vector<glm::dvec3> positions;         // in the file's own coordinates
  std::vector<std::uint32_t> face_sizes;     // corners of each face, 1 or more
  std::vector<std::uint32_t> corners;        // position of each corner or no_position; sum(face_sizes) of them
  std::vector<glm::dvec2> corner_uv;         // empty, or one for each corner (v up); NaN for corners without one
  std::vector<glm::vec4> corner_colour;      // empty, or one for each corner, linear
  std::vector<std::uint16_t> face_material;  // empty, or one for each face
  std::vector<RawMaterial> materials;
  std::vector<RawImage> images;
  std::vector<float> length_scale;  // empty, or for each position a factor of the first groom's length (built-ins)
  std::optional<Axis> up, front;    // from the file's format or its skeleton, if known
  std::string pose;                 // the animation and time that was read, "NAME@SECONDS"; "" for the file's own pose
  std::vector<std::string> animations;
  std::vector<Repair> losses;  // what was left out: missing resources, and faces that are no polygons

  /// Counts something that was left out; `name` is "" if it has none.
  void add_loss(const std::string& code, const std::string& name, std::size_t count = 1);
};

// A model ready for grooming: welded, oriented, centred and scaled so that the diagonal of its box is 1.

/// The appearance of one corner of a triangle: the model's own texture and colour. Corners keep seams that welding
/// removes from vertices.
struct LookCorner {
  glm::vec2 uv{0};          // v up
  glm::vec3 colour{1};      // linear: material colour times vertex colour
  std::int32_t image = -1;  // index in Mesh::images
};

/// In Mesh::materials: no material, or one that the report does not name.
inline constexpr std::uint16_t no_material = 0xffff;

/// A mesh ready for grooming. All per-vertex arrays have positions.size() entries, all per-triangle arrays
/// triangles.size(). Triangles are wound counter-clockwise seen from outside and have three different vertices.
struct Mesh {
  std::vector<glm::vec3> positions;  // internal: (model - centre) / size
  std::vector<glm::vec3> normals;    // unit
  std::vector<glm::vec3> tangents;   // unit, orthogonal to normals; the bitangent is cross(normal, tangent)
  std::vector<glm::uvec3> triangles;
  std::vector<std::array<glm::vec3, 3>> shading_normals;  // unit, split at creases; empty: use the vertex normals
  std::vector<std::array<LookCorner, 3>> corners;         // empty if the model has no colours of its own
  std::vector<std::array<glm::vec2, 3>> texture_uv;       // the file's own, v up, (0, 0) if unusable; empty: none
  std::vector<RawImage> images;
  std::vector<std::uint16_t> materials;  // per triangle: index in report.materials, or no_material; empty: all none
  std::vector<float> length_scale;       // for each vertex: factor of the first groom's length, (0, 4]
  glm::dvec3 centre{0};                  // centre of the bounding box, model coordinates
  double size = 1;                       // diagonal of the bounding box, in the model's unit, > 0; the unit "sizes"
  ModelReport report;

  glm::dvec3 to_internal(glm::dvec3 model) const { return (model - centre) / size; }
  glm::dvec3 to_model(glm::dvec3 internal) const { return internal * size + centre; }
};

}  // namespace pelage
