// Azimuthal averages of fibre scattering over the width of a fibre, for shells, and the lobes of marschner.
// Shells see no offset across a fibre: 1/2 the integral of Ap Np over h in [-1, 1] (science.md 4).
#pragma once

#include <array>
#include <vector>

#include "renderer/shading/fibre.h"

namespace pelage {

/// The average over the width of a fibre, by Gauss-Legendre in gamma = asin h. For energy_conserving theta is the eye's
/// inclination, as in the near-field formulas, so that the furnace stays exact; for marschner it is theta_d.
class AzimuthalAverage {
 public:
  /// `shading` is energy_conserving or marschner.
  AzimuthalAverage(ShadingModel shading, const FibreOptics& fibre);

  /// 1/2 the integral over h of Ap Np for each lobe, in parts that tables share: values for each node and lobe.
  /// `spread` holds Np and the weight, `passed` Ap. `cos_theta` in [0, 1], `azimuth` in [-pi, pi], `sigma_a` >= 0.
  /// Scales of N under .02 count as that: narrower ones fall between the nodes.
  using NodeValues = std::vector<LobeValues>;
  NodeValues exits(double cos_theta) const;
  NodeValues spread(const NodeValues& exits, double azimuth) const;
  NodeValues passed(double cos_theta, double sigma_a) const;
  LobeValues sum(const NodeValues& spread, const NodeValues& passed, double cos_theta, double azimuth) const;

 private:
  double distribution(double apart) const;

  bool marschner_;
  double eta_;
  double width_;                       // of the distribution around the exact azimuth: s, or the caustic width, radians
  double share_;                       // of the distribution in [-pi, pi], outside of which it is cut
  std::vector<QuadratureNode> nodes_;  // x = h in [0, 1]: both halves are alike
};

// Marschner 2003: R, TT and TRT, each a Gaussian along the strand times a distribution around it. Does not conserve
// energy: science.md 4 has how far off it is. The axis and the angles are those of fibre.h.

struct MarschnerLobes {
  LobeValues centre{};       // theta_h of the peak, radians; the fourth lobe is not used and has no weight
  LobeValues width{};        // standard deviation of theta_h, radians, at least 1e-3
  double caustic_width = 0;  // spread of TT and TRT around the strand, radians: they are infinite at the caustics
  double eta = 1.55;
};
MarschnerLobes marschner_lobes(const FibreOptics& fibre);

/// NR of a smooth fibre in closed form: 1/4 cos(phi/2) times Fresnel; azimuth in [-pi, pi].
double marschner_reflection(double cos_theta_d, double azimuth, double eta);

}  // namespace pelage
