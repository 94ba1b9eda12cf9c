// Fibre scattering: Fresnel, absorption, the lobes of a fibre, and sampling of its paths.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "protocol/commands/look.h"

namespace pelage {

/// Share of unpolarised light that a smooth dielectric reflects, in [0, 1]. `cos_incidence` in [0, 1] on the side of
/// index 1, `eta` >= 1 the index behind the surface. Exact (Fresnel); 1 at grazing incidence for every eta.
double fresnel_dielectric(double cos_incidence, double eta);

struct QuadratureNode {
  double x = 0;
  double weight = 0;
};

/// Gauss-Legendre nodes for the integral over [from, to]: exact for polynomials of degree 2 count - 1. `count` >= 1.
std::vector<QuadratureNode> gauss_legendre(int count, double from, double to);

// The parts of a fibre model: how light spreads along the strand (M), how much is left (A) and how it spreads around it
// (N). Marschner 2003, d'Eon 2011, Chiang 2016; values in science.md 4. A direction is (sin theta, cos theta cos phi,
// cos theta sin phi) about the strand's axis; theta is the inclination from the plane across it. The axis of these
// formulas points from tip to root, so that a positive cuticle tilt turns reflected light to the root.

/// R, TT, TRT and, for energy conserving models, the sum of all longer paths.
constexpr int lobe_count = 4;
using LobeValues = std::array<double, lobe_count>;

/// Variance v of the longitudinal term of R for beta_m in [0, 1] (Chiang 2016), at least 4e-7: TT has a quarter of it.
double longitudinal_variance(double beta_m);

/// Scale s of the logistic distribution for beta_n in [0, 1] (Chiang 2016), at least 1e-4.
double azimuthal_scale(double beta_n);

/// exp(-x) I0(x) for x >= 0: the modified Bessel function without its growth, to 2e-7.
float scaled_bessel_i0(float x);

/// `angle` in [-pi, pi], whole turns taken off; by a rounding, which is many times as fast as std::remainder. |angle| <
/// 1e9.
double wrapped_angle(double angle);

/// The logistic distribution of scale s > 0, and the share of it in [-pi, pi].
double logistic(double x, double s);
double logistic_share(double s);

/// The x below which a share u in (0, 1) lies of the logistic distribution of scale s > 0, cut to [-pi, pi].
double sample_trimmed_logistic(double u, double s);

/// sigma_a per fibre radius for each channel, >= 0. Colour: Chiang 2016, a colour in [0, 1]; values under 1e-6 count
/// as that. Melanin: concentrations >= 0, the weighted pigments of Chiang 2016.
glm::dvec3 absorption_from_colour(const glm::dvec3& colour, double beta_n);
glm::dvec3 absorption_from_melanin(double eumelanin, double pheomelanin);

/// The polynomial in beta_n by which Chiang 2016 divides the logarithm of the colour.
double colour_polynomial(double beta_n);

/// sin of the refracted azimuthal angle for an offset h in [-1, 1] across the fibre: h / eta'.
double refracted_offset(double h, double cos_theta, double eta);

/// Azimuth through which a ray of `internal` = p segments inside the fibre leaves: 2 p gamma_t - 2 gamma + p pi,
/// radians.
double exit_azimuth(int internal, double h, double cos_theta, double eta);

/// Light that goes each way, of 1 that arrives: Ap for p = 0, 1, 2 and the sum of the rest. The four add up to 1 where
/// `sigma_a` is 0.
LobeValues attenuation(double cos_theta, double h, double sigma_a, double eta);

/// All that energy_conserving needs of a look, worked out once.
struct FibreLobes {
  LobeValues variance{};
  LobeValues tilt{};  // what is added to theta of the eye, radians
  double azimuthal_scale = 0;
  double eta = 1.55;
  LobeValues tilt_sine{}, tilt_cosine{};
  LobeValues whole{};          // -v (exp(-2 / v) - 1), by which Mp is normalised
  double azimuthal_whole = 1;  // tanh(pi / (2 s)), the share of the logistic distribution within [-pi, pi]
};
FibreLobes energy_conserving_lobes(const FibreOptics& fibre);

// energy_conserving for paths: evaluated fast in float, and sampled by its lobes (Chiang 2016; science.md 4). A
// direction is (sin theta, cos theta cos phi, cos theta sin phi) about the axis of fibre.h, from tip to root.

struct FibreSample {
  glm::vec3 direction{1, 0, 0};  // where the light comes from
  glm::vec3 weight{0};           // value over pdf; never more than 1 but for rounding and the cuticle's tilt
  float pdf = 0;                 // 1 / steradian; 0 where no light comes
};

/// One fibre seen from one direction at one offset: worked out once, asked for many lights.
class FibrePaths {
 public:
  /// `eye` is unit, where the light goes; h in [-1, 1]; sigma_a >= 0 by channel.
  FibrePaths(const FibreLobes& lobes, glm::vec3 view, float h, glm::vec3 sigma_a);

  /// Sum of Mp Ap Np for light from a unit direction: the cosine is in it, 1 / steradian.
  glm::vec3 value(glm::vec3 light) const;
  float pdf(glm::vec3 light) const;  // of sample(), 1 / steradian
  /// u chooses the lobe and the azimuth, v the inclination; all in [0, 1).
  FibreSample sample(glm::vec2 u, glm::vec2 v) const;

 private:
  struct Lobe {
    glm::vec3 left{0};            // Ap
    float share = 0;              // of the samples
    double sine = 0, cosine = 1;  // of the eye's inclination, tilted by the cuticle
    double azimuth = 0;           // about which the light leaves, [-pi, pi]
    double variance = 1;
    float over_variance = 1;
    float normal = 1;  // factor of Mp
  };

  std::array<float, lobe_count> shapes(glm::vec3 light) const;  // Mp Np
  std::size_t choose(float u) const;
  glm::vec3 direction_of(std::size_t p, float u, glm::vec2 v) const;

  std::array<Lobe, lobe_count> lobes_;
  double scale_ = 1;
  float over_scale_ = 1, logistic_normal_ = 1;
};

}  // namespace pelage
