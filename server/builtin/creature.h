// The built-in creature: a young four-legged animal made from blended volumes. Y up, facing +Z, mirrored in X,
// paws on Y = 0, about 1.4 long and 1.2 high.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "server/builtin/implicit.h"

namespace pelage {

/// Positions that both the volumes and the colours refer to. For paired features they are those of the +X side.
namespace creature {
inline constexpr glm::dvec3 kHead{0, .845, .375};
inline constexpr glm::dvec3 kNose{0, .802, .652};
inline constexpr glm::dvec3 kEye{.088, .862, .538};
inline constexpr glm::dvec3 kEyeball{.0855, .8625, .5155};
inline constexpr double kEyeballRadius = .0375;
inline constexpr glm::dvec3 kEarBase{.128, .975, .345};
inline constexpr glm::dvec3 kEarTip{.205, 1.175, .315};
inline constexpr glm::dvec3 kEarFront{.36, .08, .93};  // direction that the ear's hollow faces; about unit
inline constexpr glm::dvec3 kEarHollowBase = kEarBase + .078 * kEarFront + glm::dvec3(0, .035, 0);
inline constexpr glm::dvec3 kEarHollowTip = kEarTip + .042 * kEarFront - glm::dvec3(0, .02, 0);
inline constexpr double kEarHollowBaseRadius = .078, kEarHollowTipRadius = .02;
inline constexpr glm::dvec3 kForepaw{.113, .044, .225};
inline constexpr glm::dvec3 kHindPaw{.119, .044, -.195};
inline constexpr glm::dvec3 kTailRoot{0, .50, -.33};
inline constexpr glm::dvec3 kTailTip{0, .905, -.60};
}  // namespace creature

std::vector<Volume> creature_volumes();

/// The look of the creature at a position on or near its surface.
struct CreatureLook {
  glm::dvec3 colour{1};     // linear
  double length_scale = 1;  // relative fur length of the first groom, (0, 4]
};
CreatureLook creature_look(glm::dvec3 position);

}  // namespace pelage
