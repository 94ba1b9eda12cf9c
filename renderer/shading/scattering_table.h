// The azimuthal part of energy_conserving and marschner, tabulated for the GPU.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "protocol/commands/look.h"
#include "renderer/shading/marschner.h"

namespace pelage {

/// Averages of Ap Np over the fibre's width. Values are 4 floats, one for each lobe (R, TT, TRT, residual), at ((k
/// inclinations + j) azimuths + i) 4: the layout of a 3D texture of that width, height and depth. Nodes are evenly
/// spaced on each axis; the first and the last lie at the ends of the range:
///   i: azimuth_coordinate(|phi|) in [0, 1];
///   j: cos theta in [0, 1], of the view (energy_conserving) or theta_d (marschner);
///   k: absorption coordinate exp(-3 sqrt(sigma_a)) in [0, 1].
struct ScatteringTable {
  int azimuths = 0;
  int inclinations = 0;
  int absorptions = 0;
  std::vector<float> values;

  bool empty() const { return values.empty(); }
};

/// Returns the table; empty for models that need none. It depends only on shading, eta, azimuthal roughness and caustic
/// width: not on colours, nor on anything along the strand.
ScatteringTable make_scattering_table(const Look& look);

/// Returns the coordinate on the first axis for |phi| in [0, pi]: (1 - cos / (|cos| + sin)) / 2, half the perimeter of
/// a square.
double azimuth_coordinate(double azimuth);

/// Returns the coordinate on the third axis for sigma_a >= 0.
double absorption_coordinate(double sigma_a);

// The uniform block that renderer/shaders/scattering.glsl reads besides the table: a look's parameters, computed in
// double.

/// Mirrors ScatteringBlock of scattering_block.glsl, layout std140.
struct ScatteringBlock {
  glm::ivec4 model;      // number of the ShadingModel; 1 if the absorption is given; 0; 0
  glm::vec4 weights;     // diffuse, specular, secondary specular, shift spread
  glm::vec4 exponents;   // diffuse, specular, secondary; 3 / colour polynomial, from colour to absorption coordinate
  glm::vec4 shifts;      // primary, secondary, 0, 0
  glm::vec4 absorption;  // absorption coordinates if they are given; 0
  glm::vec4 tilt_sine;   // for each lobe: energy_conserving
  glm::vec4 tilt_cosine;
  glm::vec4 centre;         // for each lobe: theta_h of the peak, radians; marschner
  glm::vec4 over_variance;  // for each lobe: 1 over the variance along the strand
  glm::vec4 normaliser;     // for each lobe: factor of the exponential; 0 for a lobe that does not exist
};
static_assert(sizeof(ScatteringBlock) == 10 * 16);

ScatteringBlock scattering_block(const Look& look);

}  // namespace pelage
