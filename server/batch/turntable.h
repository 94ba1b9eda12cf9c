// Rotates the camera or the lights of a turntable.
#pragma once

#include "protocol/commands/job.h"
#include "protocol/commands/settings.h"
#include "server/surface/mesh.h"

namespace pelage {

/// Returns the camera rotated by `degrees`, counter-clockwise seen from above, about the vertical axis through its
/// target. An automatic camera is placed first.
Camera turned_camera(const Camera& camera, double aspect, const Mesh& mesh, double degrees);

/// Return the lights and the environment, rotated in the same way. Ground and eyes do not change.
std::vector<Light> turned_lights(const std::vector<Light>& lights, glm::dvec3 pivot, double degrees);
Environment turned_environment(Environment environment, double degrees);

}  // namespace pelage
