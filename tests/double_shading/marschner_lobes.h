// How Marschner 2003 spreads light along a strand, in double.
#pragma once

#include "renderer/shading/marschner.h"
#include "tests/double_shading/fibre_lobes.h"

namespace pelage {

/// The smallest cos^2 theta_d that is divided by: beyond 88.2 degrees the model grows without bound.
constexpr double min_cos2_difference = 1e-3;

/// g(beta, theta_h - alpha) / (2 cos^2 theta_d) for each lobe; g has area 1 over theta_h, so half of it has area 1 over
/// theta_i.
LobeValues marschner_longitudinal(const MarschnerLobes& lobes, const Inclination& light, const Inclination& view);

/// cos of theta_d, half the difference of both inclinations, in [0, 1].
double cos_difference(const Inclination& light, const Inclination& view);

}  // namespace pelage
