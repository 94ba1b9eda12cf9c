// A scene with one of its coats alone.
#pragma once

#include "server/scene/scene.h"

namespace pelage {

/// Holds the settings and fields of a scene in which all coats but one are muted. The scene has to outlive it.
class CoatAlone {
 public:
  /// `coat` is the id of one of the scene's coats.
  CoatAlone(const SceneView& scene, CoatId coat);

  const Coat& coat() const;
  /// Returns the scene with this coat selected; it refers to this object.
  SceneView view() const;

 private:
  SceneView scene_;
  SceneSettings settings_;
  FieldSet fields_;
};

}  // namespace pelage
