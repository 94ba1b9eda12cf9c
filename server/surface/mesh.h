// The raw model that a parser makes of a file (polygons in double, nothing repaired yet), and the prepared Mesh.
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
  std::string name = {};     // that the file gives it; "" for none
};

/// In RawModel::corners: a vertex that the file does not have.
inline constexpr std::uint32_t no_position = 0xffffffff;

/// Notes that name at most so many of what was left out.
inline constexpr std::size_t named_losses = 8;

/// Polygons of a model after node transforms. Corners are listed face by face.
struct RawModel {
  bool is_32_bit = false;                    // whether the file's coordinates are 32-bit numbers
  std::vector<glm::dvec3> positions;         // in the file's own coordinates
  std::vector<std::uint32_t> face_sizes;     // corners of each face, 1 or more
  std::vector<std::uint32_t> corners;        // position of each corner or no_position; sum(face_sizes) of them
  std::vector<glm::dvec2> corner_uv;         // empty, or one for each corner (v up); NaN where a corner has none
  std::vector<glm::vec4> corner_colour;      // empty, or one for each corner, linear
  std::vector<std::uint16_t> face_material;  // empty, or one for each face
  std::vector<RawMaterial> materials;
  std::vector<RawImage> images;
  std::vector<float> length_scale;  // empty, or one for each position: first groom's length (built-ins)
  std::optional<Axis> up, front;    // as the file itself says, by its format or its skeleton
  std::string pose;                 // that it was read in, "NAME@SECONDS"; "" as the file has it
  std::vector<std::string> animations;
  std::vector<Repair> losses;  // what the file names and nobody has, and what is no polygon

  /// Counts something that was left out; "" has no name.
  void lose(const std::string& code, const std::string& name, std::size_t count = 1);
};

// A model ready for grooming: welded, oriented, centred and scaled so that the diagonal of its box is 1.

/// What one corner of a triangle looks like: the model's own texture and colour (seams survive welding here).
struct LookCorner {
  glm::vec2 uv{0};          // v up
  glm::vec3 colour{1};      // linear: material colour times vertex colour
  std::int32_t image = -1;  // index in Mesh::images
};

/// In Mesh::materials: one that the report does not name.
inline constexpr std::uint16_t no_material = 0xffff;

/// All per-vertex arrays have positions.size() entries; all per-triangle arrays triangles.size().
/// Triangles are wound counter-clockwise seen from outside and hold three different vertices.
struct Mesh {
  std::vector<glm::vec3> positions;  // internal: (model - centre) / size
  std::vector<glm::vec3> normals;    // unit
  std::vector<glm::vec3> tangents;   // unit, orthogonal to normals; the bitangent is cross(normal, tangent)
  std::vector<glm::uvec3> triangles;
  std::vector<std::array<glm::vec3, 3>> shading_normals;  // unit, split at creases; empty: those of the vertices
  std::vector<std::array<LookCorner, 3>> corners;         // empty when the model has no colours of its own
  std::vector<std::array<glm::vec2, 3>> texture_uv;       // the file's own, v up, (0, 0) where bad; empty: none
  std::vector<RawImage> images;
  std::vector<std::uint16_t> materials;  // of each triangle: index in report.materials, or no_material; empty: all none
  std::vector<float> length_scale;       // for each vertex: the first groom's length over the asked one, (0, 4]
  glm::dvec3 centre{0};                  // of the box, model coordinates
  double size = 1;                       // diagonal of the box, model's unit, > 0
  ModelReport report;

  glm::dvec3 to_internal(glm::dvec3 model) const { return (model - centre) / size; }
  glm::dvec3 to_model(glm::dvec3 internal) const { return internal * size + centre; }
};

}  // namespace pelage
