// A scene's groom on a new version of its model.
#pragma once

#include <cstddef>

#include "protocol/commands/answers.h"
#include "server/fields/field_set.h"
#include "server/scene/scene.h"

namespace pelage {

struct CarriedGroom {
  FieldSet fields;
  SceneSettings settings;
  CarriedReport report;
};

/// Fields, edit layers and the mask go over by the surface: each vertex of `model` takes what lies nearest to it on the
/// scene's model. What stands on the skin goes to the nearest skin, and sizes stay as long as they are in the model's
/// unit. Both models are taken to lie in the same coordinates, unless vertices lie nearer, by the median, where the
/// new one's box is scaled to the old one's. Checkpoints are dropped. A picture on the skin goes along where the new
/// model has texture coordinates. Parts with a new material that is left bare begin bare.
CarriedGroom carried_groom(const SceneSnapshot& now, const SceneModel& model);

}  // namespace pelage
