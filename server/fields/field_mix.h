// Fields between vertices, and on another mesh: means in the frame of the vertex that they are for.
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

/// A vertex that counts in a mean.
struct MixShare {
  std::uint32_t vertex = 0;
  double weight = 0;  // [0, 1]; the weights of a mean sum to 1
};

/// The mean of a field over vertices of `from`, for vertex `vertex` of `to`. Directions are 3-vectors in the tangent
/// planes, turned by the smallest rotation to the vertex's own (science.md 3), so that each keeps its inclination;
/// colours count by how much they cover (premultiplied). A single vertex with the same frame gives its bits.
glm::dvec4 mixed(const FieldSet& fields, Field field, std::span<const MixShare> shares, const Mesh& from,
                 const Mesh& to, std::uint32_t vertex);

/// All fields and edit layers on a subdivided mesh: what was there, and at each new vertex the mean of its parents
/// (SubdividedSurface::parents).
FieldSet subdivided(const FieldSet& fields, const Mesh& before, const Mesh& after,
                    const std::vector<glm::uvec2>& parents, const std::vector<EditLayer>& layers = {});

/// All fields and edit layers on another mesh: at each of its vertices the mean of vertices of the mesh before, lengths
/// times `longer`.
FieldSet carried(const FieldSet& fields, const Mesh& before, const Mesh& after,
                 const std::vector<std::array<MixShare, 3>>& shares, double longer,
                 const std::vector<EditLayer>& layers = {});

/// All fields and edit layers on a mesh that has been turned: directions turn along. Both meshes have the same
/// vertices, which `turn` rotates from `before` to `after`.
FieldSet turned(const FieldSet& fields, const Mesh& before, const Mesh& after, const glm::dmat3& turn,
                const std::vector<EditLayer>& layers = {});

}  // namespace pelage
