// Marschner 2003: R, TT and TRT, each a Gaussian along the strand times a distribution around it. Does not conserve
// energy: science.md 4 has how far off it is. The axis and the angles are those of fibre.h.
#pragma once

#include "renderer/shading/fibre.h"

namespace pelage {

struct MarschnerLobes {
  LobeValues centre{};       // theta_h of the peak, radians; the fourth lobe is not used and has no weight
  LobeValues width{};        // standard deviation of theta_h, radians, at least 1e-3
  double caustic_width = 0;  // spread of TT and TRT around the strand, radians
  double eta = 1.55;
};
MarschnerLobes marschner_lobes(const FibreOptics& fibre);

/// The smallest cos^2 theta_d that is divided by: beyond 88.2 degrees the model grows without bound.
constexpr double least_cos2_difference = 1e-3;

/// g(beta, theta_h - alpha) / (2 cos^2 theta_d) for each lobe; g has area 1 over theta_h, so half of it has area 1 over
/// theta_i.
LobeValues marschner_longitudinal(const MarschnerLobes& lobes, const Inclination& light, const Inclination& eye);

/// cos of theta_d, half the difference of both inclinations, in [0, 1].
double cos_difference(const Inclination& light, const Inclination& eye);

/// NR of a smooth fibre in closed form: 1/4 cos(phi/2) times Fresnel; azimuth in [-pi, pi].
double marschner_reflection(double cos_theta_d, double azimuth, double eta);

/// How TT and TRT spread around their exact azimuth: a Gaussian cut to [-pi, pi] and normalised there. The exact
/// distribution is infinite at the caustics.
double caustic_spread(double apart, double width);

}  // namespace pelage
