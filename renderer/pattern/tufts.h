// Tufts: clumps larger than the tile, placed on the surface in the rest pose.
#pragma once

#include <glm/glm.hpp>

#include "protocol/commands/coat.h"
#include "renderer/pattern/rest_pose.h"

namespace pelage {

struct TuftPull {
  glm::vec3 to_middle{0};  // vector along the surface from a root to where the tips of its tuft gather, sizes
  float inside = 1;        // 0 on the border between tufts, 1 in the middle
};

/// Returns the tuft of a root. Middles are scattered one to a cell of each scale; those near the surface count. A finer
/// scale gathers inside the coarser ones, with half the strength. `normal` is unit. Deterministic in all arguments.
TuftPull tuft_at(const Tufts& tufts, glm::vec3 root, glm::vec3 normal);

/// The same for a root on a surface that has moved: `to_middle` is in the current pose.
inline TuftPull tuft_at(const Tufts& tufts, const RestPosePoint& root) {
  TuftPull tuft = tuft_at(tufts, root.position, root.normal);
  tuft.to_middle = root.rotation * tuft.to_middle;
  return tuft;
}

/// Returns an upper bound on the length of `to_middle`, sizes.
float longest_pull(const Tufts& tufts);

/// Returns the share of `to_middle` that strands have moved at height s in [0, 1]: 0 at the root, at most .6 at the
/// tip. Short fur gathers less: the shaders keep a strand from moving sideways by more than its length.
float gathered(const Tufts& tufts, float s);

}  // namespace pelage
