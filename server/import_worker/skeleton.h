// Which way an animal looks, by its skeleton.
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

/// The side that a joint's name says: a word of it is l or left, r or right. Words end at other signs than letters, at
/// digits and before a capital letter.
BodySide side_of_joint(const std::string& name);

/// Returns the axis orthogonal to `up` along which an animal looks: its left joints lie on one side of it, its right
/// joints on the other. None where the joints of its meshes do not say, or say a direction between the axes.
std::optional<Axis> front_by_joints(const aiScene& scene, const NodePlaces& places, Axis up);

}  // namespace pelage
