// A model that turns before the camera.
#pragma once

#include "protocol/commands/job.h"
#include "protocol/commands/settings.h"
#include "server/surface/mesh.h"

namespace pelage {

/// The camera of a request after `degrees` of a turn of itself, counter-clockwise seen from above, about the vertical
/// axis through what it looks at. An automatic camera is placed first.
Camera turned_camera(const Camera& camera, double aspect, const Mesh& mesh, double degrees);

/// Returns the lights turned with it. Ground and eyes do not change.
std::vector<Light> turned_lights(const std::vector<Light>& lights, glm::dvec3 pivot, double degrees);
Environment turned_environment(Environment environment, double degrees);

}  // namespace pelage
