// Fibre scattering: Fresnel, absorption, the lobes of a fibre, and importance sampling of its lobes.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "protocol/commands/look.h"

namespace pelage {

/// Returns the share of unpolarised light that a smooth dielectric reflects, in [0, 1]. `cos_incidence` in [0, 1] on
/// the side of index 1; `eta` >= 1: the index behind the surface. Exact (Fresnel); 1 at grazing incidence for every
/// eta.
double fresnel_dielectric(double cos_incidence, double eta);

struct QuadratureNode {
  double x = 0;
  double weight = 0;
};

/// Returns Gauss-Legendre nodes for the integral over [from, to]: exact for polynomials of degree 2 count - 1. `count`
/// >= 1.
std::vector<QuadratureNode> gauss_legendre(int count, double from, double to);

// The terms of a fibre model: the longitudinal term M, the attenuation A and the azimuthal term N. Marschner 2003,
// d'Eon 2011, Chiang 2016; values in science.md 4. A direction is (sin theta, cos theta cos phi, cos theta sin phi)
// about the strand's axis; theta is the inclination from the plane across it. The axis of these formulas points from
// tip to root, so that a positive cuticle tilt shifts reflected light towards the root.

/// R, TT, TRT and the residual: in energy-conserving models the sum of all longer paths.
constexpr int lobe_count = 4;
using LobeValues = std::array<double, lobe_count>;

/// Returns the variance v of the longitudinal term of R for beta_m in [0, 1] (Chiang 2016), at least 4e-7; TT has a
/// quarter of it.
double longitudinal_variance(double beta_m);

/// Returns the scale s of the logistic distribution for beta_n in [0, 1] (Chiang 2016), at least 1e-4.
double azimuthal_scale(double beta_n);

/// Returns exp(-x) I0(x), the modified Bessel function scaled by its growth, for x >= 0; relative error 2e-7.
float scaled_bessel_i0(float x);

/// Returns the angle reduced to [-pi, pi], for |angle| < 1e9; by rounding, which is many times as fast as
/// std::remainder.
double wrapped_angle(double angle);

/// Return the density of the logistic distribution of scale s > 0, and its probability of [-pi, pi].
double logistic(double x, double s);
double logistic_share(double s);

/// Returns the inverse CDF at u in (0, 1) of the logistic distribution of scale s > 0, trimmed to [-pi, pi].
double sample_trimmed_logistic(double u, double s);

/// Return sigma_a per fibre radius for each channel, >= 0. Colour: after Chiang 2016, in [0, 1]; values below 1e-6
/// count as 1e-6. Melanin: concentrations >= 0, with the weighted pigments of Chiang 2016.
glm::dvec3 absorption_from_colour(const glm::dvec3& colour, double beta_n);
glm::dvec3 absorption_from_melanin(double eumelanin, double pheomelanin);

/// Returns the polynomial in beta_n by which Chiang 2016 divides the logarithm of the colour.
double colour_polynomial(double beta_n);

/// Returns the sine of the refracted azimuthal angle for an offset h in [-1, 1] across the fibre: h / eta'.
double refracted_offset(double h, double cos_theta, double eta);

/// Returns the exit azimuth of a ray with `internal` = p segments inside the fibre: 2 p gamma_t - 2 gamma + p pi,
/// radians.
double exit_azimuth(int internal, double h, double cos_theta, double eta);

/// Returns the shares of light that leave by each path: Ap for p = 0, 1, 2 and the sum of all others. They add up to 1
/// if `sigma_a` is 0.
LobeValues attenuation(double cos_theta, double h, double sigma_a, double eta);

/// The parameters of energy_conserving for a look.
struct FibreLobes {
  LobeValues variance{};
  LobeValues tilt{};  // added to theta of the view direction, radians
  double azimuthal_scale = 0;
  double eta = 1.55;
  LobeValues tilt_sine{}, tilt_cosine{};
  LobeValues longitudinal_normalisation{};  // -v (exp(-2 / v) - 1), the divisor that normalises Mp
  double azimuthal_normalisation = 1;       // tanh(pi / (2 s)), the share of the logistic distribution within [-pi, pi]
};
FibreLobes energy_conserving_lobes(const FibreOptics& fibre);

// energy_conserving for path tracing: evaluated fast in float, and sampled by its lobes (Chiang 2016; science.md 4).
// Directions are as above.

struct FibreSample {
  glm::vec3 direction{1, 0, 0};  // where the light comes from
  glm::vec3 weight{0};           // value over pdf; at most 1, except for rounding and the cuticle's tilt
  float pdf = 0;                 // 1 / steradian; 0 if no light comes
};

/// One fibre, seen from one direction at one offset: prepared once and evaluated for many light directions.
class FibrePaths {
 public:
  /// `view`: unit direction in which the light leaves; h in [-1, 1]; sigma_a >= 0 by channel.
  FibrePaths(const FibreLobes& lobes, glm::vec3 view, float h, glm::vec3 sigma_a);

  /// Returns the sum of Mp Ap Np for light from a unit direction, cosine included, 1 / steradian.
  glm::vec3 value(glm::vec3 light) const;
  float pdf(glm::vec3 light) const;  // of sample(), 1 / steradian
  /// u chooses the lobe and the azimuth, v the inclination; all in [0, 1).
  FibreSample sample(glm::vec2 u, glm::vec2 v) const;

 private:
  struct Lobe {
    glm::vec3 left{0};            // Ap
    float share = 0;              // probability of the lobe in sample()
    double sine = 0, cosine = 1;  // of the view's inclination, tilted by the cuticle
    double azimuth = 0;           // centre of the azimuthal lobe, [-pi, pi]
    double variance = 1;
    float over_variance = 1;
    float normal = 1;  // normalisation of Mp
  };

  std::array<float, lobe_count> shapes(glm::vec3 light) const;  // Mp Np of each lobe
  std::size_t choose(float u) const;
  glm::vec3 direction_of(std::size_t p, float u, glm::vec2 v) const;

  std::array<Lobe, lobe_count> lobes_;
  double scale_ = 1;
  float over_scale_ = 1, logistic_normal_ = 1;
};

}  // namespace pelage
