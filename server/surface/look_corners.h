// What the corners of triangles look like.
#pragma once

#include "server/surface/mesh.h"
#include "server/surface/soup.h"

namespace pelage {

/// Looks of all corners, from the materials, vertex colours and texture coordinates of the file; empty when the model
/// has no colours of its own: no picture, and one grey all over, which is what programs write when nobody chose one.
/// Colours that are not finite or negative count as white.
std::vector<std::array<LookCorner, 3>> look_corners(const RawModel& raw, const Soup& soup);

/// The file's texture coordinates of all corners, whether or not it has a picture; empty when it has none.
std::vector<std::array<glm::vec2, 3>> texture_corners(const RawModel& raw, const Soup& soup);

}  // namespace pelage
