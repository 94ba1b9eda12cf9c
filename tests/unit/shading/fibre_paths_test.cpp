// The float version of energy_conserving against the double one, and its sampling against its pdf.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "renderer/shading/fibre.h"
#include "tests/double_shading/fibre_lobes.h"

namespace pelage {
namespace {

using std::numbers::pi;

FibreLobes lobes_of(double beta_m, double beta_n, double alpha, double eta = 1.55) {
  FibreOptics fibre;
  fibre.longitudinal_roughness = beta_m;
  fibre.azimuthal_roughness = beta_n;
  fibre.cuticle_tilt = alpha;
  fibre.refractive_index = eta;
  return energy_conserving_lobes(fibre);
}

glm::vec3 direction_of(double theta, double phi) {
  const double t = glm::radians(theta), p = glm::radians(phi);
  return glm::vec3(std::sin(t), std::cos(t) * std::cos(p), std::cos(t) * std::sin(p));
}

Inclination inclination_of(glm::vec3 rounded) {
  const glm::dvec3 d = glm::dvec3(rounded) / glm::length(glm::dvec3(rounded));
  return {d.x, std::hypot(d.y, d.z)};
}

/// The double value for the same rounded directions.
double truth_of(const FibreLobes& lobes, glm::vec3 light, glm::vec3 view, float h, float sigma_a) {
  const double azimuth = std::atan2(double(light.z), double(light.y)) - std::atan2(double(view.z), double(view.y));
  return scatter_at_offset(lobes, inclination_of(light), inclination_of(view), azimuth, double(h), double(sigma_a));
}

TEST(FibrePaths, AgreesWithReferenceValues) {
  const struct {
    double theta_o, phi_o, theta_i, phi_i, h, sigma_a, beta_m, beta_n, alpha, value;
  } rows[] = {
      {10, 30, -5, 200, .3, 0, .3, .3, 2, 3.63775384},       {10, 30, -5, 200, .3, .25, .3, .3, 2, 2.21998413},
      {-40, 90, 35, 60, -.7, .25, .3, .3, 2, 0.00255699099}, {60, 20, -70, -100, .95, 1, .1, .2, 3, 0.000330542824},
      {0, 45, 0, 45, 0, 0, .3, .3, 0, 0.203438364},          {0, 45, 0, 225, 0, 0, .3, .3, 0, 5.33568738},
      {80, 10, -79, 190, .5, .1, .05, .1, 2, 0.194424243}};
  for (const auto& row : rows) {
    const FibrePaths paths(lobes_of(row.beta_m, row.beta_n, row.alpha), direction_of(row.theta_o, row.phi_o),
                           float(row.h), glm::vec3(float(row.sigma_a)));
    EXPECT_NEAR(double(paths.value(direction_of(row.theta_i, row.phi_i)).g), row.value, 2e-5 * row.value);
  }
}

void compare_with_double(const FibreLobes& lobes, glm::vec3 view, float h, int& compared) {
  const glm::vec3 sigma_a(0, 0.3f, 1e4f);
  const FibrePaths paths(lobes, view, h, sigma_a);
  for (const double theta : {-90.0, -89.9, -35.0, 0.0, 10.001, 60.0, 90.0}) {
    for (const double phi : {-180.0, -100.0, 0.0, 0.01, 30.0, 170.0}) {
      const glm::vec3 light = direction_of(theta, phi), value = paths.value(light);
      for (int channel = 0; channel < 3; ++channel) {
        const double truth = truth_of(lobes, light, view, h, sigma_a[channel]);
        ASSERT_NEAR(double(value[channel]), truth, 1e-3 * truth + 1e-5)
            << "theta " << theta << " phi " << phi << " h " << h << " view " << view.x << " sigma " << sigma_a[channel]
            << " s " << lobes.azimuthal_scale << " v " << lobes.variance[0] << " eta " << lobes.eta;
        ++compared;
      }
    }
  }
}

TEST(FibrePaths, IsTheDoubleSumEverywhere) {
  int compared = 0;
  for (const double eta : {1.0, 1 + 1e-6, 1.55, 3.0}) {
    for (const double beta_m : {0.0, 1e-4, 0.3, 1.0}) {
      for (const double beta_n : {0.0, 1e-4, 0.3, 1.0}) {
        for (const double theta : {-90.0, -60.0, 0.0, 10.0, 89.9, 90.0}) {
          for (const float h : {-1.0f, -0.4f, 0.0f, 0.99f, 1.0f}) {
            const FibreLobes lobes = lobes_of(beta_m, beta_n, beta_m > 0.1 ? 3 : 0, eta);
            ASSERT_NO_FATAL_FAILURE(compare_with_double(lobes, direction_of(theta, 30), h, compared));
          }
        }
      }
    }
  }
  EXPECT_GT(compared, 200000);
}

/// A point of the four-dimensional additive recurrence of Roberts 2018.
glm::vec4 numbers(int i) {
  const double root = 1.1673039782614187;
  glm::vec4 u;
  double step = 1;
  for (int k = 0; k < 4; ++k) {
    step /= root;
    const double x = 0.5 + (i + 1) * step;
    u[k] = std::min(float(x - std::floor(x)), 0x1.fffffep-1f);
  }
  return u;
}

/// Integrates over all directions, in even steps of sin theta.
double over_directions(const std::function<double(glm::vec3)>& f) {
  constexpr int side = 600;
  double sum = 0;
  for (int i = 0; i < side * side; ++i) {
    const double x = 2 * (i / side + 0.5) / side - 1, phi = 2 * pi * (i % side + 0.5) / side, c = std::sqrt(1 - x * x);
    sum += f(glm::vec3(x, c * std::cos(phi), c * std::sin(phi)));
  }
  return sum * 4 * pi / (side * side);
}

TEST(FibrePaths, DensityIntegratesToOneAndIsSampled) {
  for (const double alpha : {0.0, 2.0}) {
    const FibrePaths paths(lobes_of(0.4, 0.5, alpha), direction_of(25, 40), 0.4f, {0.1f, 0.5f, 1});
    EXPECT_NEAR(over_directions([&](glm::vec3 d) { return double(paths.pdf(d)); }), 1, 1e-3);
    constexpr int count = 400000;
    double covered = 0;
    glm::dvec3 sum(0);
    for (int i = 0; i < count; ++i) {
      const glm::vec4 u = numbers(i);
      const FibreSample s = paths.sample({u.x, u.y}, {u.z, u.w});
      ASSERT_NEAR(s.pdf, paths.pdf(s.direction), 1e-5f * s.pdf);
      ASSERT_NEAR(s.weight.r, paths.value(s.direction).r / s.pdf, 1e-4f);
      ASSERT_LE(std::max({s.weight.r, s.weight.g, s.weight.b}), 1.00001f);
      covered += 1 / double(s.pdf) / count;
      sum += glm::dvec3(s.weight) / double(count);
    }
    EXPECT_NEAR(covered, 4 * pi, 0.3);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(sum[c], over_directions([&](glm::vec3 d) { return double(paths.value(d)[c]); }), 1e-3);
    }
  }
}

TEST(FibrePaths, WhiteFibreLosesNothing) {
  for (const double roughness : {0.0, 0.1, 0.3, 0.8}) {
    for (const double theta : {0.0, 30.0, -70.0, 85.0}) {
      for (const double alpha : {0.0, 2.0}) {
        const FibrePaths paths(lobes_of(roughness, roughness, alpha), direction_of(theta, 10), 0.6f, glm::vec3(0));
        double sum = 0;
        for (int i = 0; i < 4000; ++i) {
          const glm::vec4 u = numbers(i);
          sum += double(paths.sample({u.x, u.y}, {u.z, u.w}).weight.g) / 4000;
        }
        EXPECT_NEAR(sum, 1, alpha > 0 ? 0.01 : 1e-3) << "roughness " << roughness << " theta " << theta;
      }
    }
  }
}

constexpr int rows = 24, columns = 48;

std::size_t cell_of(glm::vec3 d) {
  const int row = std::min(int((double(d.x) + 1) / 2 * rows), rows - 1);
  const int column = std::min(int((std::atan2(double(d.z), double(d.y)) + pi) / (2 * pi) * columns), columns - 1);
  return std::size_t(row * columns + column);
}

TEST(FibrePaths, HistogramIsTheDensity) {
  const FibrePaths paths(lobes_of(0.3, 0.3, 3), direction_of(20, -30), -0.5f, {0, 0.2f, 0.6f});
  std::vector<double> expected(rows * columns), found(rows * columns);
  constexpr int finer = 16, count = 1000000;
  for (int i = 0; i < rows * columns * finer * finer; ++i) {
    const double x = 2 * (i / (columns * finer) + 0.5) / (rows * finer) - 1, c = std::sqrt(1 - x * x);
    const double phi = 2 * pi * (i % (columns * finer) + 0.5) / (columns * finer);
    const glm::vec3 d(x, c * std::cos(phi), c * std::sin(phi));
    expected[cell_of(d)] += double(paths.pdf(d)) * 4 * pi / (rows * columns * finer * finer);
  }
  for (int i = 0; i < count; ++i) {
    const glm::vec4 u = numbers(i);
    found[cell_of(paths.sample({u.x, u.y}, {u.z, u.w}).direction)] += 1.0 / count;
  }
  double apart = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) apart += std::abs(expected[i] - found[i]) / 2;
  EXPECT_LT(apart, 0.01);
}

TEST(FibrePaths, SamplesOfSmoothFibresStayFinite) {
  for (const double roughness : {0.0, 1e-4, 1.0}) {
    for (const double theta : {-90.0, -89.99, 0.0, 45.0, 90.0}) {
      for (const float h : {-1.0f, 0.0f, 0.7f, 1.0f}) {
        for (const double eta : {1.0, 1 + 1e-6, 3.0}) {
          const FibrePaths paths(lobes_of(roughness, roughness, 2, eta), direction_of(theta, 10), h, {0, 1, 1e4f});
          for (int i = 0; i < 200; ++i) {
            glm::vec4 u = numbers(i);
            for (int k = 0; k < 4 && i < 16; ++k) u[k] = i >> k & 1 ? 0x1.fffffep-1f : 0.0f;  // all corners
            const FibreSample s = paths.sample({u.x, u.y}, {u.z, u.w});
            ASSERT_TRUE(std::isfinite(s.weight.r + s.weight.g + s.weight.b + s.pdf));
            ASSERT_NEAR(glm::length(s.direction), 1, 1e-5f);
            ASSERT_GT(s.pdf, 0);
            ASSERT_NEAR(s.weight.r, 1, 0.001f) << "roughness " << roughness << " theta " << theta;
          }
        }
      }
    }
  }
}

TEST(FibrePaths, BlackFibreWithoutASurfaceAnswersNothing) {
  const FibrePaths paths(lobes_of(0.3, 0.3, 0, 1), direction_of(20, 0), 0.2f, glm::vec3(1e4f));
  const FibreSample s = paths.sample({0.4f, 0.4f}, {0.4f, 0.4f});
  EXPECT_EQ(s.pdf, 0);
  EXPECT_EQ(s.weight, glm::vec3(0));
  EXPECT_EQ(paths.pdf(direction_of(-20, 180)), 0);
}

TEST(Fibre, LogisticIsSampledByItsInverse) {
  for (const double s : {1e-4, 0.02, 0.3, 4.0}) {
    double below = 0;  // cumulative distribution by quadrature, over the widths that matter
    const double edge = std::min(pi, 30 * s);
    for (int i = 0; i < 20000; ++i) {
      const double step = 2 * edge / 20000, x = -edge + (i + 0.5) * step;
      below += trimmed_logistic(x, s) * step;
      if (i % 1000 != 999 || below > 0.999999) continue;
      EXPECT_NEAR(sample_trimmed_logistic(below, s), x + step / 2, 1e-3 * s + 1e-6 / trimmed_logistic(x, s));
    }
  }
}

}  // namespace
}  // namespace pelage
