#include "server/export/eye_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pelage {

namespace {

constexpr int rings = 96, sectors = 96;  // of a ball; the first ring is at its front, the last at its back

/// Returns 1 from `edge` on, 0 up to edge - soft, and a linear ramp between.
float step(double edge, double soft, double value) {
  return static_cast<float>(std::clamp((value - edge) / soft + 1, 0.0, 1.0));
}

/// Returns whether a direction is in the opening of the lids, between two arcs that meet in the corners.
bool is_open(const FurLids& lids, glm::vec3 direction) {
  const glm::dvec3 at(glm::transpose(lids.frame) * direction);
  const glm::dvec3 opening(lids.opening);
  const double across = std::atan2(at.x, at.z) / opening.x, up = std::asin(std::clamp(at.y, -1.0, 1.0));
  const double bow = 1 - across * across;
  return std::abs(across) < 1 && up < opening.y * bow && up > -opening.z * bow;
}

/// Returns the linear colour in a direction from the centre of the ball, unit.
glm::vec3 colour_of(const FurEye& eye, glm::vec3 direction) {
  constexpr double soft = 0.06;
  if (eye.lids && !is_open(*eye.lids, direction)) return eye.lids->colour;
  const glm::dvec3 at(glm::transpose(eye.frame) * direction);
  if (at.z < 0) return eye.sclera;
  const double out = std::hypot(at.x, at.y) / eye.iris.size;  // 1 at the rim of the iris
  const double share = eye.pupil.size.value_or(0.5);
  const bool slit = eye.pupil.shape == PupilShape::slit;
  const double pupil = slit ? std::hypot(at.x / 0.35, at.y) / eye.iris.size : out;
  glm::vec3 colour = glm::mix(eye.iris.inner_colour, eye.iris.colour, step(share + 0.25, 0.25, out));
  colour *= 1 - static_cast<float>(eye.iris.limbal_ring) * step(1, 0.15, out);
  colour *= step(share + soft, soft, pupil);
  return glm::mix(colour, eye.sclera, step(1 + soft, soft, out));
}

struct Balls {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec4> colours;
  std::vector<glm::uvec3> triangles;

  void add(const FurEye& eye, double size) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (int ring = 0; ring <= rings; ++ring) {
      for (int sector = 0; sector <= sectors; ++sector) {
        const double polar = std::numbers::pi * ring / rings, around = 2 * std::numbers::pi * sector / sectors;
        const glm::vec3 direction = eye.frame * glm::vec3(std::sin(polar) * std::cos(around),
                                                          std::sin(polar) * std::sin(around), std::cos(polar));
        positions.push_back((eye.position + eye.radius * direction) * static_cast<float>(size));
        normals.push_back(direction);
        colours.emplace_back(colour_of(eye, direction), 1);
      }
    }
    constexpr std::uint32_t row = sectors + 1;
    for (std::uint32_t ring = 0; ring < rings; ++ring) {
      for (std::uint32_t sector = 0; sector < sectors; ++sector) {
        const std::uint32_t a = first + ring * row + sector;
        if (ring > 0) triangles.emplace_back(a, a + row, a + 1);
        if (ring + 1 < rings) triangles.emplace_back(a + 1, a + row, a + row + 1);
      }
    }
  }
};

}  // namespace

GltfJson add_eyes(GlbWriter& file, const std::vector<FurEye>& eyes, double size, int material) {
  if (eyes.empty()) return {};
  Balls balls;
  for (const FurEye& eye : eyes) balls.add(eye, size);
  return {{"attributes",
           {{"POSITION", file.add_positions(balls.positions)},
            {"NORMAL", file.add(std::span<const glm::vec3>(balls.normals))},
            {"COLOR_0", file.add(std::span<const glm::vec4>(balls.colours))}}},
          {"indices", file.add_triangles(balls.triangles, balls.positions.size())},
          {"material", material}};
}

}  // namespace pelage
