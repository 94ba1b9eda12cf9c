// What a scene begins with beside its fur.
#pragma once

#include "server/scene/scene.h"

namespace pelage {

/// The default coat, look and lights; the built-in creature has two eyes, whiskers, lashes, brows and bare skin.
SceneSettings first_settings(const SceneModel& model);

}  // namespace pelage
