// The built-in creature: its volumes polygonised and painted.
#include <algorithm>

#include "server/builtin/builtin_shapes.h"
#include "server/builtin/creature.h"
#include "server/builtin/implicit_mesh.h"

namespace pelage {
namespace {

TriangleMesh creature_mesh(int triangles) {
  constexpr double kCell = 0.0125;              // the ears are about three cells thin
  constexpr int kEvenest = 2000, kLeast = 400;  // fewer even triangles than this lose the ears; the least that has legs
  const ImplicitSurface surface(creature_volumes());
  const TriangleMesh fine = largest_part(polygonise(surface, kCell));
  const TriangleMesh even = remesh(surface, fine, std::max(triangles, kEvenest));
  return triangles < kEvenest ? decimate(even, std::max(triangles, kLeast)) : even;
}

}  // namespace

RawModel make_creature(int triangles) {
  const TriangleMesh mesh = creature_mesh(triangles);
  RawModel model = triangle_model(mesh.positions, mesh.triangles);
  std::vector<glm::vec4> colours;
  for (const glm::dvec3& position : model.positions) {
    const CreatureLook look = creature_look(position);
    colours.emplace_back(look.colour, 1);
    model.length_scale.push_back(static_cast<float>(look.length_scale));
  }
  for (const std::uint32_t corner : model.corners) model.corner_colour.push_back(colours[corner]);
  return model;
}

}  // namespace pelage
