// Every shading model in double behind one interface, as a reference for shaders and SIMD lanes.
#pragma once

#include <glm/glm.hpp>
#include <memory>

#include "renderer/shading/fibre.h"
#include "renderer/shading/marschner.h"
#include "renderer/shading/scattering_table.h"
#include "tests/double_shading/empirical.h"
#include "tests/double_shading/fibre_lobes.h"
#include "tests/double_shading/marschner_lobes.h"

namespace pelage {

/// A look's shading model, prepared once and evaluated many times. Thread-safe.
class FibreShading {
 public:
  explicit FibreShading(const Look& look);

  /// Returns the light scattered to the camera for light of radiance 1 (which a white matt surface would return as 1),
  /// three channels. The caller adds shadow, B and ambient. Directions of `geometry` are unit; `colour` in [0, 1];
  /// `strand` in [0, 1] is the strand's number. Finite and not negative for every look within its ranges. For fibre
  /// models this is pi times the sum of Mp Ap Np, averaged over h: the light enters as irradiance across the strand,
  /// without a further N.L.
  glm::dvec3 scatter(const ScatterGeometry& geometry, const glm::dvec3& colour, double strand) const;

  /// The same through a table made for this look, as the shader has it. The table may be empty for models without one.
  glm::dvec3 scatter(const ScatterGeometry& geometry, const glm::dvec3& colour, double strand,
                     const ScatteringTable& table) const;

  /// Scattering of a fibre model through its table, for a strand whose sigma_a is known.
  glm::dvec3 scatter_absorbed(const ScatterGeometry& geometry, const glm::dvec3& sigma_a,
                              const ScatteringTable& table) const;

  /// energy_conserving at one offset h in [-1, 1] across the fibre, for traced strands; see `offset_across`.
  glm::dvec3 scatter_at_offset(const ScatterGeometry& geometry, const glm::dvec3& colour, double h) const;

  /// Returns sigma_a of a strand of this colour.
  glm::dvec3 absorption(const glm::dvec3& colour) const;

 private:
  template <typename Azimuthal>
  glm::dvec3 fibre_sum(const ScatterGeometry& geometry, const glm::dvec3& sigma_a, const Azimuthal& azimuthal) const;
  glm::dvec3 empirical(const ScatterGeometry& geometry, const glm::dvec3& colour, double strand) const;
  bool is_fibre() const { return average_ != nullptr; }

  Look look_;
  FibreLobes lobes_;
  MarschnerLobes marschner_;
  std::shared_ptr<const AzimuthalAverage> average_;  // null for models that are not fibres
};

/// h of a ray that goes from a hit on a round strand to the camera: the sine of the azimuth from the normal at the hit
/// to the camera, about the axis of fibre.h. All vectors are unit; 0 if the camera is along the strand.
double offset_across(const glm::dvec3& tangent, const glm::dvec3& hit_normal, const glm::dvec3& to_camera);

}  // namespace pelage
