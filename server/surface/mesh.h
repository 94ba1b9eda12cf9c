// A model ready for grooming: welded, oriented, centred and scaled so that the diagonal of its box is 1.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "protocol/commands/answers.h"
#include "server/surface/raw_model.h"

namespace pelage {

/// What one corner of a triangle looks like: the model's own texture and colour (seams survive welding here).
struct LookCorner {
  glm::vec2 uv{0};         // v up
  glm::vec3 colour{1};     // linear: material colour times vertex colour
  std::int32_t image = -1; // index in Mesh::images
};

/// All per-vertex arrays have positions.size() entries; all per-triangle arrays triangles.size().
/// Triangles are wound counter-clockwise seen from outside and hold three different vertices.
struct Mesh {
  std::vector<glm::vec3> positions;   // internal: (model - centre) / size
  std::vector<glm::vec3> normals;     // unit
  std::vector<glm::vec3> tangents;    // unit, orthogonal to normals; the bitangent is cross(normal, tangent)
  std::vector<glm::uvec3> triangles;
  std::vector<std::array<LookCorner, 3>> corners;  // empty when the model has no colours of its own
  std::vector<std::array<glm::vec2, 3>> texture_uv;     // the file's own, v up, (0, 0) where bad; empty: none
  std::vector<RawImage> images;
  std::vector<float> length_scale;    // for each vertex: the first groom's length over the asked one, (0, 4]
  glm::dvec3 centre{0};               // of the box, model coordinates
  double size = 1;                    // diagonal of the box, model's unit, > 0
  ModelReport report;

  glm::dvec3 to_internal(glm::dvec3 model) const { return (model - centre) / size; }
  glm::dvec3 to_model(glm::dvec3 internal) const { return internal * size + centre; }
};

}  // namespace pelage
