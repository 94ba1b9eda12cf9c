// The values of science.md 4 for the parts of a fibre model, to the digits given there.
#include "renderer/shading/fibre.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "renderer/shading/marschner.h"
#include "tests/double_shading/fibre_lobes.h"

namespace pelage {
namespace {

using std::numbers::pi;

double radians(double degrees) { return degrees * pi / 180; }

Inclination inclination(double degrees) { return {std::sin(radians(degrees)), std::cos(radians(degrees))}; }

FibreOptics fibre_of(double beta_m, double beta_n, double alpha) {
  FibreOptics fibre;
  fibre.longitudinal_roughness = beta_m;
  fibre.azimuthal_roughness = beta_n;
  fibre.cuticle_tilt = alpha;
  return fibre;
}

TEST(Fibre, VarianceAndScale) {
  EXPECT_NEAR(longitudinal_variance(0.1), 0.0065157184, 5e-11);
  EXPECT_NEAR(longitudinal_variance(0.3), 0.0846111745, 5e-11);
  EXPECT_NEAR(longitudinal_variance(0.9), 3.10095766, 5e-9);
  EXPECT_NEAR(azimuthal_scale(0.1), 0.0240886977, 5e-11);
  EXPECT_NEAR(azimuthal_scale(0.3), 0.117159806, 5e-10);
}

struct NearField {
  double theta_o, phi_o, theta_i, phi_i, h, sigma_a, beta_m, beta_n, alpha, value;
};

TEST(Fibre, SumOfMpApNpAtAnOffset) {
  const NearField rows[] = {
      {10, 30, -5, 200, .3, 0, .3, .3, 2, 3.63775384},       {10, 30, -5, 200, .3, .25, .3, .3, 2, 2.21998413},
      {-40, 90, 35, 60, -.7, .25, .3, .3, 2, 0.00255699099}, {60, 20, -70, -100, .95, 1, .1, .2, 3, 0.000330542824},
      {0, 45, 0, 45, 0, 0, .3, .3, 0, 0.203438364},          {0, 45, 0, 225, 0, 0, .3, .3, 0, 5.33568738},
      {80, 10, -79, 190, .5, .1, .05, .1, 2, 0.194424243}};
  for (const NearField& row : rows) {
    const FibreLobes lobes = energy_conserving_lobes(fibre_of(row.beta_m, row.beta_n, row.alpha));
    const double value = scatter_at_offset(lobes, inclination(row.theta_i), inclination(row.theta_o),
                                           radians(row.phi_i - row.phi_o), row.h, row.sigma_a);
    EXPECT_NEAR(value / row.value, 1, 5e-9) << "theta_o " << row.theta_o << " sigma_a " << row.sigma_a;
  }
}

TEST(Fibre, ScaledBesselAgreesWithTheLibrary) {
  for (double x = 0; x < 600; x = x * 1.07 + 1e-3) {
    const double expected = std::cyl_bessel_i(0, x) * std::exp(-x);
    EXPECT_NEAR(scaled_bessel_i0(x) / expected, 1, 2e-13) << x;
    EXPECT_NEAR(double(scaled_bessel_i0(static_cast<float>(x))) / expected, 1, 1e-6) << x;
  }
}

/// Largest relative error of Mp in float, over values that are not lost in the tail.
double largest_float_error(double v) {
  double largest = 0;
  for (int i = -17; i <= 17; ++i) {
    const double middle = radians(5 * i), width = std::sqrt(v);
    for (const double step : {-3.0, -1.0, -0.1, 0.0, 0.5, 2.0}) {
      const float so = static_cast<float>(std::sin(middle)), co = static_cast<float>(std::cos(middle));
      const float si = static_cast<float>(-std::sin(middle + step * width));
      const float ci = static_cast<float>(std::abs(std::cos(middle + step * width)));
      const double truth = longitudinal(double(ci), double(co), double(si), double(so), double(float(v)));
      if (truth < 1e-6) continue;
      largest = std::max(largest, std::abs(double(longitudinal(ci, co, si, so, float(v))) / truth - 1));
    }
  }
  return largest;
}

TEST(Fibre, LongitudinalInFloatKeepsItsDigits) {
  for (double v = 1e-7; v <= 10; v *= 1.5) EXPECT_LT(largest_float_error(v), 5e-6) << "v " << v;
}

/// The shortcut of published code: ten terms of I0 up to 12, one term of the expansion of its logarithm above.
template <typename Real>
Real shortcut(Real cos_in, Real cos_out, Real sin_in, Real sin_out, Real v) {
  const Real x = cos_in * cos_out / v, y = sin_in * sin_out / v;
  Real sum = 0, term = 1;
  for (int i = 1; i <= 10; ++i) sum += term, term *= x * x / Real(4 * i * i);
  const Real log_i0 = x > 12 ? x + Real(.5) * (-std::log(2 * Real(pi)) + std::log(1 / x) + 1 / (8 * x)) : std::log(sum);
  return v <= Real(.1) ? std::exp(log_i0 - y - 1 / v + Real(.6931472) + std::log(1 / (2 * v)))
                       : std::exp(log_i0 - y) / (std::sinh(1 / v) * 2 * v);
}

TEST(Fibre, TheCommonShortcutIsNotGoodEnough) {
  const double v = 1 / 11.99;
  const double off = std::abs(shortcut(1.0, 1.0, 0.0, 0.0, v) / longitudinal(1.0, 1.0, 0.0, 0.0, v) - 1);
  EXPECT_GT(off, 0.01);
  EXPECT_LT(off, 0.03);
  const float narrow = 1e-7f, sine = 0.5f, cosine = std::sqrt(0.75f);
  const double truth = longitudinal(double(cosine), double(cosine), double(-sine), double(sine), double(narrow));
  EXPECT_GT(std::abs(double(shortcut(cosine, cosine, -sine, sine, narrow)) / truth - 1), 0.1);
}

TEST(Fibre, LongitudinalIntegratesToOne) {
  for (const double v : {1e-4, 0.0065, 0.0846, 3.1, 100.0}) {
    for (const double theta : {-85.0, -30.0, 0.0, 60.0}) {
      const Inclination out = inclination(theta);
      double sum = 0;
      for (const QuadratureNode& node : gauss_legendre(2000, -pi / 2, pi / 2)) {
        sum +=
            node.weight * std::cos(node.x) * longitudinal(std::cos(node.x), out.cosine, std::sin(node.x), out.sine, v);
      }
      EXPECT_NEAR(sum, 1, 1e-9) << "v " << v << " theta " << theta;
    }
  }
}

TEST(Fibre, LogisticIntegratesToOne) {
  for (const double s : {0.01, 0.117, 1.0, 4.3}) {
    double sum = 0;
    for (const QuadratureNode& node : gauss_legendre(2000, -pi, pi)) sum += node.weight * trimmed_logistic(node.x, s);
    EXPECT_NEAR(sum, 1, 1e-10) << s;
  }
}

TEST(Fibre, WhiteFibreLosesNothing) {
  for (const double eta : {1.0, 1 + 1e-6, 1.55, 3.0}) {
    for (const double h : {-1.0, -0.5, 0.0, 0.999, 1.0}) {
      for (const double cos_theta : {0.0, 1e-3, 0.7, 1.0}) {
        const LobeValues a = attenuation(cos_theta, h, 0, eta);
        EXPECT_NEAR(a[0] + a[1] + a[2] + a[3], 1, 1e-12) << "eta " << eta << " h " << h << " cos " << cos_theta;
      }
    }
  }
}

TEST(Fibre, DarkerWithMoreAbsorption) {
  LobeValues last = attenuation(0.8, 0.3, 0, 1.55);
  for (const double sigma_a : {0.01, 0.1, 1.0, 10.0, 1e4}) {
    const LobeValues a = attenuation(0.8, 0.3, sigma_a, 1.55);
    EXPECT_EQ(a[0], last[0]);
    for (std::size_t p = 1; p < lobe_count; ++p) EXPECT_LE(a[p], last[p]);
    last = a;
  }
  EXPECT_EQ(last[1], 0);
}

/// All light that a white fibre scatters: the integral over the sphere of directions, by quadrature only.
double furnace(const FibreLobes& lobes, const AzimuthalAverage& average, double theta_view) {
  const Inclination view = inclination(theta_view);
  LobeValues around{};
  for (const QuadratureNode& node : gauss_legendre(160, 0, pi)) {
    const LobeValues n = average_at(average, view.cosine, node.x, 0);
    for (std::size_t p = 0; p < lobe_count; ++p) around[p] += 2 * node.weight * n[p];
  }
  double sum = 0;
  for (const QuadratureNode& node : gauss_legendre(500, -pi / 2, pi / 2)) {
    const LobeValues m = longitudinal_lobes(lobes, {std::sin(node.x), std::cos(node.x)}, view);
    for (std::size_t p = 0; p < lobe_count; ++p) sum += node.weight * std::cos(node.x) * m[p] * around[p];
  }
  return sum;
}

TEST(Fibre, WhiteFurnace) {
  for (const double alpha : {0.0, 2.0, 5.0}) {
    for (const double beta : {0.1, 0.3, 0.6, 1.0}) {
      const FibreOptics fibre = fibre_of(beta, beta, alpha);
      const AzimuthalAverage average(ShadingModel::energy_conserving, fibre);
      for (const double theta : {-88.0, -40.0, 0.0, 25.0, 75.0}) {
        EXPECT_NEAR(furnace(energy_conserving_lobes(fibre), average, theta), 1, 1e-3)
            << "alpha " << alpha << " beta " << beta << " theta " << theta;
      }
    }
  }
}

TEST(Fibre, FurnaceAtOneOffset) {
  const FibreLobes lobes = energy_conserving_lobes(fibre_of(0.3, 0.3, 2));
  const Inclination view = inclination(20);
  double sum = 0;
  for (const QuadratureNode& along : gauss_legendre(200, -pi / 2, pi / 2)) {
    const Inclination light{std::sin(along.x), std::cos(along.x)};
    for (int i = 0; i < 400; ++i) {
      const double azimuth = -pi + 2 * pi * (i + 0.5) / 400;
      sum += along.weight * light.cosine * 2 * pi / 400 * scatter_at_offset(lobes, light, view, azimuth, 0.6, 0);
    }
  }
  EXPECT_NEAR(sum, 1, 1e-3);
}

TEST(Fibre, TheMiddleIsNotTheAverage) {
  const FibreOptics fibre = fibre_of(0.3, 0.3, 2);
  const FibreLobes lobes = energy_conserving_lobes(fibre);
  const Inclination level = inclination(0);
  EXPECT_NEAR(scatter_at_offset(lobes, level, level, pi, 0, 1), 0.702, 5e-4);
  const LobeValues m = longitudinal_lobes(lobes, level, level);
  const LobeValues n = average_at(AzimuthalAverage(ShadingModel::energy_conserving, fibre), 1, pi, 1);
  EXPECT_NEAR(m[0] * n[0] + m[1] * n[1] + m[2] * n[2] + m[3] * n[3], 0.234, 5e-4);
}

TEST(Fibre, AverageIsTheMeanOfOffsets) {
  const FibreOptics fibre = fibre_of(0.3, 0.2, 2);
  const FibreLobes lobes = energy_conserving_lobes(fibre);
  const AzimuthalAverage average(ShadingModel::energy_conserving, fibre);
  for (const double cos_theta : {0.2, 0.8, 1.0}) {
    for (const double azimuth : {0.0, 1.0, 2.5, pi}) {
      LobeValues mean{};
      constexpr int samples = 20000;
      for (int i = 0; i < samples; ++i) {
        const double h = -1 + 2 * (i + 0.5) / samples;
        const LobeValues a = attenuation(cos_theta, h, 0.4, lobes.eta),
                         n = azimuthal_lobes(lobes, cos_theta, h, azimuth);
        for (std::size_t p = 0; p < lobe_count; ++p) mean[p] += a[p] * n[p] / samples;
      }
      const LobeValues value = average_at(average, cos_theta, azimuth, 0.4);
      for (std::size_t p = 0; p < lobe_count; ++p)
        EXPECT_NEAR(value[p], mean[p], 2e-5) << "p " << p << " phi " << azimuth;
    }
  }
}

TEST(Absorption, OfColoursAndPigments) {
  EXPECT_EQ(absorption_from_colour(glm::dvec3(1), 0.3), glm::dvec3(0));
  const double expected =
      std::log(0.5) / (5.969 - 0.215 * 0.3 + 2.532 * 0.09 - 10.73 * 0.027 + 5.574 * 0.0081 + 0.245 * 0.00243);
  EXPECT_NEAR(absorption_from_colour(glm::dvec3(0.5), 0.3).g, expected * expected, 1e-15);
  const glm::dvec3 black = absorption_from_colour(glm::dvec3(0), 0.3);
  EXPECT_TRUE(std::isfinite(black.r) && black.r > absorption_from_colour(glm::dvec3(1e-3), 0.3).r);
  const glm::dvec3 pigments = absorption_from_melanin(2, 3);
  EXPECT_NEAR(pigments.r, 2 * 0.419 + 3 * 0.187, 1e-15);
  EXPECT_NEAR(pigments.g, 2 * 0.697 + 3 * 0.4, 1e-15);
  EXPECT_NEAR(pigments.b, 2 * 1.37 + 3 * 1.05, 1e-15);
}

}  // namespace
}  // namespace pelage
