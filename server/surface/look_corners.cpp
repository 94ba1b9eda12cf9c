#include "server/surface/look_corners.h"

#include <algorithm>
#include <cmath>

namespace pelage {

namespace {

bool is_colour(glm::vec3 c) {
  return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z) && c.x >= 0 && c.y >= 0 && c.z >= 0;
}

bool is_place(glm::dvec2 uv) {
  constexpr double farthest = 1e6;  // beyond it a 32-bit coordinate holds no place in the picture
  return std::abs(uv.x) <= farthest && std::abs(uv.y) <= farthest;
}

LookCorner look_of(const RawModel& raw, const RawMaterial& material, std::uint32_t corner) {
  LookCorner look;
  if (is_colour(material.base_colour)) look.colour = material.base_colour;
  if (!raw.corner_colour.empty() && is_colour(glm::vec3(raw.corner_colour[corner]))) {
    look.colour *= glm::vec3(raw.corner_colour[corner]);
  }
  if (!raw.corner_uv.empty() && is_place(raw.corner_uv[corner])) {
    look.uv = glm::vec2(raw.corner_uv[corner]);
    look.image = material.image;
  }
  return look;
}

/// A triangle is textured as a whole or not at all.
std::array<LookCorner, 3> look_of_triangle(const RawModel& raw, const RawMaterial& material, glm::uvec3 corners) {
  std::array<LookCorner, 3> looks;
  for (std::size_t k = 0; k < 3; ++k) looks[k] = look_of(raw, material, corners[static_cast<int>(k)]);
  const bool whole = std::all_of(looks.begin(), looks.end(), [](const LookCorner& look) { return look.image >= 0; });
  for (LookCorner& look : looks) look.image = whole ? look.image : -1;
  return looks;
}

}  // namespace

std::vector<std::array<LookCorner, 3>> look_corners(const RawModel& raw, const Soup& soup) {
  std::vector<std::array<LookCorner, 3>> looks;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    const RawMaterial material =
        raw.face_material.empty() ? RawMaterial() : raw.materials[raw.face_material[soup.faces[t]]];
    looks.push_back(look_of_triangle(raw, material, soup.corners[t]));
  }
  const glm::vec3 first = looks.front()[0].colour;
  const bool first_is_grey = first.x == first.y && first.y == first.z;
  const auto is_plain = [&](const LookCorner& look) { return look.image < 0 && look.colour == first; };
  const bool all_plain = std::all_of(looks.begin(), looks.end(), [&](const std::array<LookCorner, 3>& triangle) {
    return std::all_of(triangle.begin(), triangle.end(), is_plain);
  });
  if (first_is_grey && all_plain) looks.clear();
  return looks;
}

std::vector<std::array<glm::vec2, 3>> texture_corners(const RawModel& raw, const Soup& soup) {
  std::vector<std::array<glm::vec2, 3>> texture;
  if (raw.corner_uv.empty()) return texture;
  texture.resize(soup.corners.size(), {glm::vec2(0), glm::vec2(0), glm::vec2(0)});
  for (std::size_t t = 0; t < texture.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec2 uv = raw.corner_uv[soup.corners[t][static_cast<int>(k)]];
      if (is_place(uv)) texture[t][k] = glm::vec2(uv);
    }
  }
  return texture;
}

}  // namespace pelage
