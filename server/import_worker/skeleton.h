// Finds the front of an animal by its skeleton.
#pragma once

#include <assimp/scene.h>

#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "protocol/commands/scene.h"
#include "server/import_worker/pose.h"
#include "server/surface/mesh.h"

namespace pelage {

enum class BodySide { none, left, right };

/// Returns the side of the body in a joint's name: one of its words is l or left, r or right. Words end before a
/// character that is no letter, and before a capital letter unless it follows another and no small letter follows it.
BodySide side_of_joint(const std::string& name);

/// Returns the axis, orthogonal to `up`, along which an animal looks: its left joints lie on one side of it, its right
/// joints on the other. None if the names of the joints give no sides, or the direction is not close to an axis.
std::optional<Axis> front_by_joints(const aiScene& scene, const NodeTransforms& transforms, Axis up);

}  // namespace pelage
