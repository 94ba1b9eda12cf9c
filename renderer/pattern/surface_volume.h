// A grid about a surface that a fragment reads with one fetch, filled only where the surface is.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/pattern/rest_pose.h"

namespace pelage {

struct VolumeSurface {
  std::span<const glm::vec3> positions, normals;  // of vertices; internal coordinates, unit
  std::span<const glm::uvec3> triangles;
  std::span<const glm::vec3> rest_positions = {}, rest_normals = {};  // as FurModel has them
};

struct SurfaceVolume {
  glm::ivec3 size{1};              // cells along x, y, z; each at most 256
  glm::vec3 origin{0};             // corner of the first cell
  float cell = 1;                  // side of a cell, sizes
  std::vector<std::uint8_t> rgba;  // 0 where nothing was evaluated
};

/// What a cell holds: four values in [0, 1], from where its middle lies in the rest pose.
using VolumeValue = std::function<glm::vec4(const RestPosePoint& middle)>;

/// Evaluates the cells around the surface. A cell is .005 sizes, or more where 256 of them would not do. Deterministic.
SurfaceVolume make_surface_volume(const VolumeSurface& surface, const VolumeValue& value);

}  // namespace pelage
