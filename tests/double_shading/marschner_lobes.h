// The longitudinal lobes of Marschner 2003 in double.
#pragma once

#include "renderer/shading/marschner.h"
#include "tests/double_shading/fibre_lobes.h"

namespace pelage {

/// Lower bound of cos^2 theta_d in the denominator: beyond 88.2 degrees the model grows without bound.
constexpr double min_cos2_difference = 1e-3;

/// g(beta, theta_h - alpha) / (2 cos^2 theta_d) for each lobe; g has area 1 over theta_h, so half of it has area 1 over
/// theta_i.
LobeValues marschner_longitudinal(const MarschnerLobes& lobes, const Inclination& light, const Inclination& view);

/// cos of theta_d, half the difference of both inclinations, in [0, 1].
double cos_difference(const Inclination& light, const Inclination& view);

}  // namespace pelage
