#include "base/lean_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace pelage {
namespace {

/// Length of the curve up to `s`, summed over many chords.
double polyline_length(LeanCurve curve, double inclination, double root_share, double s) {
  constexpr int chords = 4000;
  double length = 0;
  LeanPoint last;
  for (int i = 1; i <= chords; ++i) {
    const LeanPoint next = lean_point(curve, inclination, root_share, s * i / chords);
    length += std::hypot(next.across - last.across, next.up - last.up);
    last = next;
  }
  return length;
}

TEST(LeanCurve, KeepsTheLengthExactly) {
  for (const LeanCurve curve : {LeanCurve::arc, LeanCurve::root}) {
    for (const double inclination : {0.0, 1e-9, 0.01, 0.3, 0.7, 1.0}) {
      for (const double root_share : {0.0, 0.6, 1.0}) {
        for (const double s : {0.1, 0.5, 1.0}) {
          EXPECT_NEAR(polyline_length(curve, inclination, root_share, s), s, 2e-6)
              << "curve " << int(curve) << " inclination " << inclination << " root " << root_share << " s " << s;
        }
      }
    }
  }
}

TEST(LeanCurve, UprightFurIsStraight) {
  for (const LeanCurve curve : {LeanCurve::arc, LeanCurve::root}) {
    const LeanPoint tip = lean_point(curve, 0, 0.5, 1);
    EXPECT_EQ(tip.across, 0);
    EXPECT_DOUBLE_EQ(tip.up, 1);
    EXPECT_EQ(tip.angle, 0);
  }
}

TEST(LeanCurve, RootCurveEndsWhereScienceSays) {  // science.md 2: at a = pi/2, up = across = .676 and 63.4 degrees
  const LeanPoint tip = lean_point(LeanCurve::root, 1, 0, 1);
  EXPECT_NEAR(tip.across, 0.676, 5e-4);
  EXPECT_NEAR(tip.up, 0.676, 5e-4);
  EXPECT_NEAR(tip.angle * 180 / std::numbers::pi, 63.4, 0.1);
}

TEST(LeanCurve, BothCurvesShareTheDirectionOfTheChord) {
  for (const double inclination : {0.2, 0.6, 1.0}) {
    const LeanPoint arc = lean_point(LeanCurve::arc, inclination, 0.25, 1);
    const LeanPoint root = lean_point(LeanCurve::root, inclination, 0.25, 1);
    EXPECT_NEAR(std::atan2(arc.across, arc.up), std::atan2(root.across, root.up), 1e-9);
  }
}

TEST(LeanCurve, ArcIsTheLimitOfTheSumInThePaper) {  // fur modelling 5.1 eq 1 with n segments
  constexpr int n = 20000;
  const double inclination = 0.8, tip = inclination * std::numbers::pi / 2;
  double across = 0, up = 0;
  for (int i = 0; i < n; ++i) across += std::sin(tip * (i + 0.5) / n) / n, up += std::cos(tip * (i + 0.5) / n) / n;
  const LeanPoint point = lean_point(LeanCurve::arc, inclination, 0, 1);
  EXPECT_NEAR(point.across, across, 1e-8);
  EXPECT_NEAR(point.up, up, 1e-8);
}

TEST(LeanCurve, TangentIsTheDerivative) {
  constexpr double h = 1e-5;
  for (const LeanCurve curve : {LeanCurve::arc, LeanCurve::root}) {
    for (const double s : {0.2, 0.5, 0.9}) {
      const LeanPoint before = lean_point(curve, 0.9, 0.3, s - h), after = lean_point(curve, 0.9, 0.3, s + h);
      const double angle = std::atan2(after.across - before.across, after.up - before.up);
      EXPECT_NEAR(angle, lean_point(curve, 0.9, 0.3, s).angle, 1e-6);
    }
  }
}

TEST(LeanCurve, SleekFurLiesDownFromTheRoot) {
  EXPECT_EQ(lean_point(LeanCurve::arc, 0.8, 0, 0).angle, 0);
  EXPECT_NEAR(lean_point(LeanCurve::arc, 0.8, 0.6, 0).angle, 0.6 * 0.8 * std::numbers::pi / 2, 1e-12);
  EXPECT_LT(lean_point(LeanCurve::arc, 0.8, 0.6, 1).up, lean_point(LeanCurve::arc, 0.8, 0, 1).up);
}

}  // namespace
}  // namespace pelage
