// Azimuthal averages of fibre scattering over the width of a fibre, for shells, and the lobes of marschner. Shells do
// not resolve the offset across a fibre, so they use 1/2 the integral of Ap Np over h in [-1, 1] (science.md 4).
#pragma once

#include <array>
#include <vector>

#include "renderer/shading/fibre.h"

namespace pelage {

/// The average over the width of a fibre, by Gauss-Legendre quadrature in gamma = asin h. For energy_conserving theta
/// is the view's inclination, as in the near-field formulas, so that the white furnace test stays exact; for marschner
/// it is theta_d.
class AzimuthalAverage {
 public:
  /// `shading` is energy_conserving or marschner.
  AzimuthalAverage(ShadingModel shading, const FibreOptics& fibre);

  /// Compute 1/2 the integral over h of Ap Np for each lobe, in steps that a table can share: values for each node and
  /// lobe. `spread` holds Np and the weight, `passed` Ap. `cos_theta` in [0, 1], `azimuth` in [-pi, pi], `sigma_a` >=
  /// 0. Scales of N under .02 count as that: narrower ones fall between the nodes.
  using NodeValues = std::vector<LobeValues>;
  NodeValues exits(double cos_theta) const;
  NodeValues spread(const NodeValues& exits, double azimuth) const;
  NodeValues passed(double cos_theta, double sigma_a) const;
  LobeValues sum(const NodeValues& spread, const NodeValues& passed, double cos_theta, double azimuth) const;

 private:
  double distribution(double apart) const;

  bool marschner_;
  double eta_;
  double width_;                       // of the distribution about the exact azimuth: s, or the caustic width, radians
  double share_;                       // probability of [-pi, pi], to which the distribution is trimmed
  std::vector<QuadratureNode> nodes_;  // x = h in [0, 1]: both halves are alike
};

// Marschner 2003: R, TT and TRT, each a Gaussian along the strand times a distribution around it. It does not conserve
// energy; science.md 4 says by how much. The axis and the angles are those of fibre.h.

struct MarschnerLobes {
  LobeValues centre{};       // theta_h of the peak, radians; the fourth lobe is unused and has no weight
  LobeValues width{};        // standard deviation of theta_h, radians, at least 1e-3
  double caustic_width = 0;  // azimuthal spread of TT and TRT, radians: without it they are infinite at caustics
  double eta = 1.55;
};
MarschnerLobes marschner_lobes(const FibreOptics& fibre);

/// Returns NR of a smooth fibre in closed form: 1/4 cos(phi/2) times Fresnel; azimuth in [-pi, pi].
double marschner_reflection(double cos_theta_d, double azimuth, double eta);

}  // namespace pelage
