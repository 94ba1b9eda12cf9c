#include "server/scene/first_settings.h"

#include "server/scene/creature_curves.h"
#include "server/scene/creature_skin.h"
#include "server/builtin/creature.h"

namespace pelage {

namespace {

/// A fox's eyes: amber, with slit pupils and dark, slanted lids.
std::vector<Eye> creature_eyes(const Mesh& mesh) {
  std::vector<Eye> eyes;
  for (const double side : {1.0, -1.0}) {
    Eye eye;
    eye.position = creature::kEyeball * glm::dvec3(side, 1, 1);
    eye.radius = creature::kEyeballRadius / mesh.size;
    eye.gaze = {side * 0.30, 0.04, 1};
    eye.pupil.shape = PupilShape::slit;
    eye.iris.turn_degrees = side * 37;
    eye.lids = Lids{.facing = glm::dvec3(side * 0.52, 0.10, 1), .tilt_degrees = side * 14};
    eyes.push_back(eye);
  }
  return eyes;
}

}  // namespace

SceneSettings first_settings(const SceneModel& model) {
  SceneSettings settings;
  if (model.name != "creature") return settings;
  settings.eyes = creature_eyes(model.surface.mesh());
  settings.curves = creature_curves(model.surface, settings.eyes);
  settings.skin = creature_skin(model.surface.mesh());
  return settings;
}

}  // namespace pelage
