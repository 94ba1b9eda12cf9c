// A scene at a revision, kept without its lock.
#pragma once

#include <memory>

#include "server/scene/scene.h"

namespace pelage {

/// What a SceneView shows. Fields and settings are copied; model and picture never change and are shared.
class SceneCopy {
 public:
  explicit SceneCopy(const SceneView& scene)
      : model_(scene.model_owner),
        picture_(scene.picture_owner),
        fields_(scene.fields),
        settings_(scene.settings),
        revision_(scene.revision),
        copy_id_(scene.copy_id) {}

  /// For as long as the copy lives.
  SceneView view() const {
    return {*model_, fields_, settings_, revision_, picture_.get(), copy_id_, model_, picture_};
  }

 private:
  std::shared_ptr<const SceneModel> model_;
  std::shared_ptr<const RawImage> picture_;
  FieldSet fields_;
  SceneSettings settings_;
  Revision revision_;
  std::uint64_t copy_id_;
};

}  // namespace pelage
