#include "protocol/commands/look.h"

namespace pelage {

std::vector<Light> default_lights() {
  const Light key{.direction = {-0.55, -0.75, -0.45},
                  .colour = {1.0f, 0.95f, 0.88f},
                  .intensity = 1.15,
                  .cast_shadow = CastShadow::penumbra};
  const Light fill{.direction = {0.8, -0.25, -0.5},
                   .colour = {0.80f, 0.89f, 1.0f},
                   .intensity = 0.45,
                   .cast_shadow = CastShadow::penumbra};
  const Light rim{.direction = {0.25, -0.45, 0.85},
                  .colour = {1.0f, 0.98f, 0.95f},
                  .intensity = 0.6,
                  .cast_shadow = CastShadow::penumbra};
  return {key, fill, rim};
}

}  // namespace pelage
