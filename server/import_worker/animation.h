// Poses a scene by one of its animations.
#pragma once

#include <assimp/scene.h>

#include <string>
#include <vector>

#include "base/status.h"

namespace pelage {

/// Returns the names of a scene's animations; those without one are called by their number, from "1".
std::vector<std::string> animation_names(const aiScene& scene);

/// Sets nodes and weights of morph targets to a pose of an animation. `pose` is NAME@SECONDS, where NAME is one of
/// animation_names; @SECONDS defaults to 0. Before its first and after its last key the animation holds still. Keys are
/// interpolated linearly, rotations by slerp. Refused (invalid) for an unknown name, listing the known ones, and for
/// seconds that are no number of 0 or more.
Status apply_pose(aiScene& scene, const std::string& pose);

}  // namespace pelage
