// Light from all around as a picture.
#pragma once

#include <span>

#include "protocol/base/status.h"
#include "protocol/commands/look.h"

namespace pelage {

/// Projects the radiance of a picture of all directions: rows from the top (+y) to the bottom, its middle looks along
/// -z, its right quarter along +x. `rgba` has 4 * width * height numbers in linear light; alpha is not looked at. Each
/// pixel is a patch of constant radiance and its integrals are exact, so that one pixel is uniform light. Numbers below
/// 0, which filters leave behind at sharp edges, count as 0. Refused (invalid) when a pixel is not finite, and when the
/// light is too strong for limits::harmonic.
Result<SphericalHarmonics> project_equirectangular(int width, int height, std::span<const float> rgba);

}  // namespace pelage
