// Poses a scene by one of its animations.
#pragma once

#include <assimp/scene.h>

#include <string>
#include <vector>

#include "base/status.h"

namespace pelage {

/// Names of a scene's animations; "1", "2", ... of those without one.
std::vector<std::string> animation_names(const aiScene& scene);

/// Moves nodes and weights of morph targets to where the animation has them: `pose` is NAME@SECONDS, NAME one of
/// animation_names; before its first and after its last key it holds still, without @SECONDS it begins. Keys are
/// interpolated linearly, turns by slerp. Refused (invalid) for another name, with those that there are, and for
/// seconds that are no number of 0 or more.
Status apply_pose(aiScene& scene, const std::string& pose);

}  // namespace pelage
