// The azimuthal part of energy_conserving and marschner as an array that the GPU reads.
#pragma once

#include <vector>

#include "renderer/shading/azimuthal_average.h"

namespace pelage {

/// Averages of Ap Np over the fibre's width. Values are 4 floats, one for each lobe (R, TT, TRT, the rest), at
/// ((k inclinations + j) azimuths + i) 4: the layout of a 3D texture of that width, height and depth. On each axis the
/// first and the last node lie on the ends of the range, evenly spaced between:
///   i: |phi| in [0, pi];  j: cos theta in [0, 1], of the eye (energy_conserving) or theta_d (marschner);
///   k: absorption coordinate exp(-3 sqrt(sigma_a)) in [0, 1].
struct ScatteringTable {
  int azimuths = 0;
  int inclinations = 0;
  int absorptions = 0;
  std::vector<float> values;

  bool empty() const { return values.empty(); }
  /// Trilinear, as a texture unit does it. Not for an empty table.
  LobeValues at(double cos_theta, double azimuth, double absorption_coordinate) const;
};

/// Empty for models that need none. It depends on shading, eta, azimuthal roughness and caustic width alone:
/// not on colours, nor on anything along the strand.
ScatteringTable make_scattering_table(const Look& look);

/// The third axis of the table, for sigma_a >= 0.
double absorption_coordinate(double sigma_a);

}  // namespace pelage
