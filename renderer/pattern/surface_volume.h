// A grid around a surface that a fragment reads with one fetch, filled only near the surface.
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
  std::span<const glm::vec3> positions, normals;  // for each vertex; internal coordinates, unit
  std::span<const glm::uvec3> triangles;
  std::span<const glm::vec3> rest_positions = {}, rest_normals = {};  // as in FurModel
};

struct SurfaceVolume {
  glm::ivec3 size{1};              // cells along x, y, z; each at most 256
  glm::vec3 origin{0};             // corner of the first cell
  float cell = 1;                  // side of a cell, sizes
  std::vector<std::uint8_t> rgba;  // four values a cell; 0 where nothing was evaluated
};

/// Computes a cell: four values in [0, 1], from the position of the cell's middle in the rest pose.
using VolumeValue = std::function<glm::vec4(const RestPosePoint& middle)>;

/// Evaluates the cells around the surface. A cell is .005 sizes, or larger if 256 of them do not suffice.
/// Deterministic.
SurfaceVolume make_surface_volume(const VolumeSurface& surface, const VolumeValue& value);

}  // namespace pelage
