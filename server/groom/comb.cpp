#include <cmath>

#include "server/groom/brush.h"
#include "server/groom/tools.h"
#include "server/groom/vertex_frame.h"
#include "server/groom/working_set.h"

namespace pelage {

namespace {

/// Combs the whole surface one way.
void comb_flood(const Comb& command, const Mesh& mesh, WorkingSet& work) {
  if (!command.direction || command.brush.strength == 0) return;
  const glm::dvec3 towards = safe_unit(*command.direction) * (command.brush.invert ? -1.0 : 1.0);
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    WorkingSet::Fur& fur = work.at(v);
    fur.direction = turned(fur.direction, frame_at(mesh, v), towards, command.lean, command.brush.strength);
  }
}

/// Each dab turns fur the way that the brush moved. The exponent makes many small dabs do what one large one does.
void comb_stroke(const Comb& command, const Surface& surface, WorkingSet& work) {
  const BrushStroke stroke(*command.stroke, command.brush, surface);
  std::vector<VertexWeight> weights;
  for (const Dab& dab : stroke.moving_dabs()) {
    const glm::dvec3 towards = command.brush.invert ? -dab.motion : dab.motion;
    stroke.weigh(dab, weights);
    for (const auto [vertex, weight] : weights) {
      WorkingSet::Fur& fur = work.at(vertex);
      fur.direction = turned(fur.direction, frame_at(surface.mesh(), vertex), towards, command.lean,
                             1 - std::pow(1 - weight, dab.step));
    }
  }
}

}  // namespace

Evaluation comb(const Comb& command, const Surface& surface, const FieldSet& fields) {
  WorkingSet work(fields);
  if (command.flood)
    comb_flood(command, surface.mesh(), work);
  else if (command.stroke)
    comb_stroke(command, surface, work);
  return {work.delta(), 0};
}

}  // namespace pelage
