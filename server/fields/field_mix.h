// Interpolates fields between vertices, and transfers them to other meshes, by means in the target vertex's frame.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "protocol/commands/field.h"
#include "server/fields/field_set.h"
#include "server/surface/mesh.h"

namespace pelage {

/// A vertex and its weight in a mean.
struct MixShare {
  std::uint32_t vertex = 0;
  double weight = 0;  // [0, 1]; the weights of a mean sum to 1
};

/// Returns the mean of a field over vertices of `from`, for vertex `vertex` of `to`. Directions are 3-vectors in the
/// tangent planes, rotated by the smallest rotation to the plane of `vertex` (science.md 3), so that each keeps its
/// inclination; colours are premultiplied by their coverage. A single vertex with the same frame gives its exact value.
glm::dvec4 mixed(const FieldSet& fields, Field field, std::span<const MixShare> shares, const Mesh& from,
                 const Mesh& to, std::uint32_t vertex);

/// Returns all fields and edit layers on a subdivided mesh: old vertices keep their values, and each new vertex has the
/// mean of its parents (SubdividedSurface::parents).
FieldSet subdivided(const FieldSet& fields, const Mesh& before, const Mesh& after,
                    const std::vector<glm::uvec2>& parents, const std::vector<EditLayer>& layers = {});

/// Returns all fields and edit layers on another mesh: each of its vertices has the mean of vertices of the mesh
/// before. Lengths are multiplied by `length_scale`.
FieldSet transferred(const FieldSet& fields, const Mesh& before, const Mesh& after,
                     const std::vector<std::array<MixShare, 3>>& shares, double length_scale,
                     const std::vector<EditLayer>& layers = {});

/// Returns all fields and edit layers on a rotated mesh, with rotated directions. Both meshes have the same vertices,
/// which `rotation` rotates from `before` to `after`.
FieldSet rotated(const FieldSet& fields, const Mesh& before, const Mesh& after, const glm::dmat3& rotation,
                 const std::vector<EditLayer>& layers = {});

}  // namespace pelage
