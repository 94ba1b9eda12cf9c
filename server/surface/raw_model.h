// What a parser makes of a file: polygons in double, nothing repaired yet.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace pelage {

/// 8-bit sRGB colour with straight alpha, rows from the top, 4 * width * height bytes.
struct RawImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

struct RawMaterial {
  glm::vec3 base_colour{1};  // linear; multiplies the image and the vertex colours
  int image = -1;            // index in RawModel::images, -1 for none
};

/// In RawModel::corners: a vertex that the file does not have.
inline constexpr std::uint32_t no_position = 0xffffffff;

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
};

}  // namespace pelage
