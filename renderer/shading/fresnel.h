#pragma once

namespace pelage {

/// Share of unpolarised light that a smooth dielectric reflects, in [0, 1]. `cos_incidence` in [0, 1] on the side of
/// index 1, `eta` >= 1 the index behind the surface. Exact (Fresnel); 1 at grazing incidence for every eta.
double fresnel_dielectric(double cos_incidence, double eta);

}  // namespace pelage
