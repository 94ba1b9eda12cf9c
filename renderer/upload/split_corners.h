// A model's vertices, split where the corners of its triangles differ: what is sent to a GPU.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/input/fur_scene.h"

namespace pelage {

/// A vertex in its buffer.
struct RenderVertex {
  glm::vec3 position, normal, tangent;
  glm::vec2 tile_uv;
  glm::vec3 tile_axis, image_uv, colour;
  float weight;
  glm::vec3 shading_normal;  // that the surface is seen by; fur grows along `normal`
};

struct SplitModel {
  std::vector<RenderVertex> vertices;
  std::vector<glm::uvec3> triangles;  // in render vertices
  std::vector<std::uint32_t> welded;  // the model's vertex of each render vertex, rising
  std::vector<std::uint32_t> first;   // of each model's vertex, its first render vertex; one more at the end
};

SplitModel split_corners(const FurModel& model);

/// For each render vertex the value of its vertex (SplitModel::welded); none for none.
std::vector<glm::vec3> by_vertex(std::span<const glm::vec3> values, std::span<const std::uint32_t> welded);

}  // namespace pelage
