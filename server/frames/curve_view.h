// Guided curves as the renderer wants them.
#pragma once

#include "renderer/input/fur_scene.h"
#include "server/scene/scene.h"

namespace pelage {

/// In internal coordinates; each guide knows the skin nearest to its root and the fur that stands there now.
FurCurves make_curves(const CurveGroup& group, const SceneView& scene);

}  // namespace pelage
