// Transfers a scene's groom to a new version of its model.
#pragma once

#include <cstddef>

#include "protocol/commands/answers.h"
#include "server/fields/field_set.h"
#include "server/scene/scene.h"

namespace pelage {

struct TransferredGroom {
  FieldSet fields;
  SceneSettings settings;
  TransferReport report;
};

/// Transfers fields, edit layers and the mask by proximity: each vertex of `model` takes the values at the nearest
/// position of the scene's model. Objects on the skin move to the nearest skin, and sizes keep their length in the
/// model's unit. Both models are assumed to share coordinates, unless scaling the new model's bounding box to the old
/// one's brings its vertices nearer by the median distance. Checkpoints are dropped. The skin texture is kept if the
/// new model has texture coordinates. Parts with a new material that is left bare start bare.
TransferredGroom transferred_groom(const SceneSnapshot& now, const SceneModel& model);

}  // namespace pelage
