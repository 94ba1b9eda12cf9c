// A scene's model and fields on finer triangles.
#pragma once

#include <cstdint>
#include <memory>

#include "protocol/base/status.h"
#include "protocol/commands/scene.h"
#include "server/scene/scene.h"

namespace pelage {

struct SubdividedScene {
  std::shared_ptr<const SceneModel> model;  // null where no triangle was chosen
  FieldSet fields;
};

/// As Scene::subdivide says; `id` is that of the new model. At each level the mask chooses anew, as it is there.
Result<SubdividedScene> subdivide_scene(const SceneModel& model, const FieldSet& fields,
                                        const std::vector<EditLayer>& layers, const Subdivide& how, std::uint64_t id);

}  // namespace pelage
