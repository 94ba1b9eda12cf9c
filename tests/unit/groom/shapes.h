// Models and commands that the tests of grooming share.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <utility>
#include <vector>

#include "protocol/commands/command.h"
#include "server/builtin/builtin.h"
#include "server/fields/field_set.h"
#include "server/groom/vertex_frame.h"
#include "server/surface/prepare.h"
#include "server/surface/surface.h"

namespace pelage::testing_shapes {

inline Surface make_surface(Builtin shape, int triangles) {
  Result<Mesh> mesh = prepare(make_builtin({shape, triangles}));
  EXPECT_TRUE(mesh.ok()) << mesh.status().message;
  if (!mesh.ok()) std::abort();
  return Surface(std::move(*mesh));
}

/// A stroke through points in internal coordinates.
inline Stroke stroke_through(const Surface& surface, const std::vector<glm::dvec3>& internal) {
  Stroke stroke;
  for (const glm::dvec3 point : internal) {
    StrokeSample sample;
    sample.position = PositionSample{surface.mesh().to_model(point)};
    stroke.samples.push_back(sample);
  }
  return stroke;
}

/// The outermost vertex in a direction.
inline std::uint32_t vertex_towards(const Surface& surface, glm::dvec3 direction) {
  std::uint32_t best = 0;
  const auto& positions = surface.mesh().positions;
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    if (glm::dot(glm::dvec3(positions[v]), direction) > glm::dot(glm::dvec3(positions[best]), direction)) best = v;
  }
  return best;
}

/// The lean of a vertex's fur as a vector in space; its length is the inclination.
inline glm::dvec3 lean_of(const Surface& surface, const Groom& groom, std::uint32_t vertex) {
  const VertexFrame frame = frame_at(surface.mesh(), vertex);
  return double{groom.direction.x} * frame.tangent + double{groom.direction.y} * frame.bitangent;
}

}  // namespace pelage::testing_shapes
