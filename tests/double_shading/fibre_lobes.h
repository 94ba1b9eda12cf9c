// The parts of the energy_conserving model in double, as a reference for the float versions. Names and values are those
// of renderer/shading/fibre.h.
#pragma once

#include "renderer/shading/fibre.h"
#include "renderer/shading/marschner.h"
#include "renderer/shading/scattering_table.h"

namespace pelage {

/// The inclination of a direction, as its sine and cosine; cosine >= 0.
struct Inclination {
  double sine = 0;
  double cosine = 1;
};

double scaled_bessel_i0(double x);

/// Mp of d'Eon 2011, normalised: its integral over theta_i with cos theta_i is 1. Finite for v in [1e-7, inf).
double longitudinal(double cos_in, double cos_out, double sin_in, double sin_out, double v);
float longitudinal(float cos_in, float cos_out, float sin_in, float sin_out, float v);

/// The logistic distribution of scale s > 0, cut to [-pi, pi] and normalised there; x in [-pi, pi].
double trimmed_logistic(double x, double s);

/// Mp for each lobe, with the view's inclination tilted by the cuticle.
LobeValues longitudinal_lobes(const FibreLobes& lobes, const Inclination& light, const Inclination& view);

/// Np for each lobe at an offset h: near field. `azimuth` is phi of the light minus phi of the view, radians.
LobeValues azimuthal_lobes(const FibreLobes& lobes, double cos_theta_view, double h, double azimuth);

/// Sum of Mp Ap Np at an offset h in [-1, 1] across the fibre: 1 / steradian, with the cosine of theta_i in it.
double scatter_at_offset(const FibreLobes& lobes, const Inclination& light, const Inclination& view, double azimuth,
                         double h, double sigma_a);

/// 1/2 the integral over h of Ap Np for each lobe.
LobeValues average_at(const AzimuthalAverage& average, double cos_theta, double azimuth, double sigma_a);

/// Trilinear interpolation, as a texture unit does it. The table must not be empty.
LobeValues table_at(const ScatteringTable& table, double cos_theta, double azimuth, double absorption_coordinate);

}  // namespace pelage
