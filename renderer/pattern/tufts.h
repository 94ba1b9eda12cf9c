// Tufts: clumps larger than the tile, anchored on the surface.
#pragma once

#include <glm/glm.hpp>

#include "protocol/commands/coat.h"
#include "renderer/pattern/rest_pose.h"

namespace pelage {

struct TuftPlace {
  glm::vec3 to_middle{0};  // from a root to where the tips of its tuft gather, along the surface, sizes
  float inside = 1;        // 0 on the border between tufts, 1 in the middle
};

/// The tuft of a root. Middles are scattered one to a cell of each scale, of which those near the surface count; a
/// finer scale gathers inside the coarser ones, half as far. `normal` is unit. Deterministic in all arguments.
TuftPlace tuft_at(const Tufts& tufts, glm::vec3 root, glm::vec3 normal);

/// The same of a place of a surface that has moved: `to_middle` lies along it as it is now.
inline TuftPlace tuft_at(const Tufts& tufts, const RestPosePoint& root) {
  TuftPlace tuft = tuft_at(tufts, root.place, root.normal);
  tuft.to_middle = root.turn * tuft.to_middle;
  return tuft;
}

/// No pull is longer, sizes.
float longest_pull(const Tufts& tufts);

/// How far strands have gathered at height s in [0, 1]: 0 at the root, at most .6 at the tip. Short fur gathers less:
/// the shaders keep a strand from going to the side by more than its length.
float gathered(const Tufts& tufts, float s);

}  // namespace pelage
