#include "renderer/coat/folds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>

#include "protocol/base/lean_curve.h"
#include "protocol/base/random.h"

namespace pelage {
namespace {

constexpr double whole_shift = 0.63661977236758138;  // across, of the arc at inclination 1: 2 / pi

struct Furred {
  std::vector<glm::vec3> positions, normals, tangents;
  std::vector<glm::uvec3> triangles;
  std::vector<glm::vec2> direction;
  std::vector<float> length;
  LeanCurve curve = LeanCurve::arc;

  FurredSurface view() const { return {positions, normals, tangents, triangles, direction, length, curve, 0}; }
  void lean_by(const std::vector<float>& factors) {
    for (std::size_t v = 0; v < factors.size(); ++v) direction[v] *= factors[v];
  }
};

/// The square [-1, 1]^2 in `cells`^2 pairs of triangles, with fur that moves the tips of the shells by `shift` along
/// it.
Furred sheet(int cells, const std::function<glm::dvec2(glm::dvec2)>& shift) {
  Furred made;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const glm::dvec2 at = 2.0 * glm::dvec2(i, j) / double(cells) - 1.0, moved = shift(at);
      const double far = glm::length(moved);
      made.positions.emplace_back(at, 0);
      made.direction.emplace_back(far > 0 ? moved / far : glm::dvec2(0));
      made.length.push_back(static_cast<float>(far / whole_shift));
    }
  }
  made.normals.assign(made.positions.size(), {0, 0, 1});
  made.tangents.assign(made.positions.size(), {1, 0, 0});
  const auto vertex = [&](int i, int j) { return static_cast<std::uint32_t>(j * (cells + 1) + i); };
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      made.triangles.emplace_back(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      made.triangles.emplace_back(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  }
  return made;
}

/// The inside of an octahedral ball of radius 1, with upright fur.
Furred hollow(double length) {
  Furred made;
  for (const glm::vec3 side : {glm::vec3(1, 0, 0), {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
    made.positions.push_back(side);
    made.normals.push_back(-side);
    made.tangents.emplace_back(side.y, side.z, side.x);
  }
  made.triangles = {{4, 2, 0}, {4, 1, 2}, {4, 3, 1}, {4, 0, 3}, {5, 0, 2}, {5, 2, 1}, {5, 1, 3}, {5, 3, 0}};
  made.direction.assign(6, glm::vec2(0));
  made.length.assign(6, static_cast<float>(length));
  return made;
}

std::size_t folds_after_limits(Furred fur) {
  fur.lean_by(fold_limits(fur.view()));
  return count_folds(fur.view());
}

TEST(Folds, ThirtyMillimetresShiftNineteen) {  // science.md 1
  EXPECT_NEAR(30 * lean_point(LeanCurve::arc, 1, 0, 1).across, 19, 0.15);
  EXPECT_NEAR(lean_point(LeanCurve::arc, 1, 0, 1).across, whole_shift, 1e-12);
}

/// Fur that meets in a line: the shell is narrowed by the factor 1 - c across(s) and turns over where that is 0.
TEST(Folds, WhereFurMeetsTheShellTurnsOverAtTheHeightOfTheFormula) {
  const auto meeting = [](double c) { return sheet(8, [c](glm::dvec2 at) { return glm::dvec2(-c * at.x, 0); }); };
  EXPECT_EQ(count_folds(meeting(0.99).view()), 0u);
  for (const double c : {1.02, 1.4, 3.0, 40.0}) {
    double expected = 2;
    for (int k = 8; k >= 1; --k) {
      if (c / whole_shift * lean_point(LeanCurve::arc, 1, 0, k / 8.0).across >= 1) expected = k / 8.0;
    }
    for (const double height : fold_heights(meeting(c).view())) EXPECT_EQ(height, expected) << c;
  }
}

/// Fur that meets in a point turns over on both axes: the determinant is above 0 again, and it has folded all the same.
TEST(Folds, WhereFurMeetsInAPointBothAxesTurnOver) {
  const auto sink = [](double c) { return sheet(6, [c](glm::dvec2 at) { return -c * at; }); };
  EXPECT_EQ(count_folds(sink(0.99).view()), 0u);
  EXPECT_EQ(count_folds(sink(1.02).view()), 72u);
  EXPECT_EQ(count_folds(sink(3).view()), 72u);
}

TEST(Folds, WhereFurPartsOrSwirlsNothingTurnsOver) {
  EXPECT_EQ(count_folds(sheet(6, [](glm::dvec2 at) { return 5.0 * at; }).view()), 0u);
  EXPECT_EQ(count_folds(sheet(6, [](glm::dvec2 at) { return 5.0 * glm::dvec2(-at.y, at.x); }).view()), 0u);
  EXPECT_EQ(count_folds(sheet(6, [](glm::dvec2) { return glm::dvec2(5, 1); }).view()), 0u);
}

/// 30 mm of fur on a body of 1 m whose heading jumps from one side to the other between vertices 10 mm apart: the shift
/// is 19 mm to either side. Parted fur tears the shell open, fur that meets turns it over, in that column of cells
/// alone.
TEST(Folds, AJumpOfTheHeadingTurnsOverOnlyWhereFurMeets) {
  const auto jump = [](double sign) {
    return sheet(201, [sign](glm::dvec2 at) { return glm::dvec2(at.x < 0 ? sign : -sign, 0) * 0.03 * whole_shift; });
  };
  EXPECT_EQ(count_folds(jump(1).view()), 2u * 201);
  EXPECT_EQ(count_folds(jump(-1).view()), 0u);
}

TEST(Folds, InAHollowFurLongerThanItIsWideTurnsOver) {
  EXPECT_EQ(count_folds(hollow(0.9).view()), 0u);
  for (const double height : fold_heights(hollow(1.2).view())) EXPECT_EQ(height, 0.875);  // 1.05 radii
  EXPECT_EQ(folds_after_limits(hollow(1.2)), 8u);  // fur that does not lean cannot lean less
}

TEST(FoldLimits, LeaveFurAloneThatDoesNotFold) {
  const Furred fur = sheet(6, [](glm::dvec2 at) { return glm::dvec2(-0.8 * at.x, 0.3 * at.y); });
  for (const float factor : fold_limits(fur.view())) EXPECT_EQ(factor, 1);
}

TEST(FoldLimits, OnlyFurThatMeetsLeansLess) {
  Furred fur = sheet(201, [](glm::dvec2 at) { return glm::dvec2(at.x < 0 ? 1 : -1, 0) * 0.03 * whole_shift; });
  const std::vector<float> factors = fold_limits(fur.view());
  for (std::size_t v = 0; v < factors.size(); ++v) {
    const double away = std::abs(double(fur.positions[v].x));
    EXPECT_GE(factors[v], away > 0.1 ? 1 : 0) << away;
    EXPECT_LE(factors[v], away < 0.01 ? 0.6 : 1) << away;
  }
  fur.lean_by(factors);
  EXPECT_EQ(count_folds(fur.view()), 0u);
}

/// Where all corners are limited alike, the shell is left with a tenth of its width, and with no more than is needed.
TEST(FoldLimits, KeepATenthOfTheWidth) {
  Furred fur = sheet(1, [](glm::dvec2 at) { return glm::dvec2(-3 * at.x, 0); });
  const double inclination = double(fold_limits(fur.view())[0]);
  const double narrowed = 1 - 3 / whole_shift * lean_point(LeanCurve::arc, inclination, 0, 1).across;
  EXPECT_NEAR(narrowed, 0.1, 0.01);
  EXPECT_GE(narrowed, 0.1 - 1e-5);
}

TEST(FoldLimits, NoFurOnASheetFoldsHoweverItIsCombed) {
  for (const LeanCurve curve : {LeanCurve::arc, LeanCurve::root}) {
    Random random(11);
    Furred fur = sheet(20, [](glm::dvec2) { return glm::dvec2(0); });
    for (std::size_t v = 0; v < fur.length.size(); ++v) {
      const double turn = 7 * random.uniform();
      fur.direction[v] = glm::vec2(glm::dvec2(std::cos(turn), std::sin(turn)) * random.uniform());
      fur.length[v] = static_cast<float>(random.uniform());
    }
    fur.curve = curve;
    EXPECT_GT(count_folds(fur.view()), 200u);
    EXPECT_EQ(folds_after_limits(fur), 0u);
  }
}

TEST(Folds, AreTheSameHoweverTheModelLiesAndHoweverLargeItIs) {
  const Furred fur = sheet(9, [](glm::dvec2 at) { return glm::dvec2(-2 * at.x * at.x * at.x, 0.6 * at.x * at.y); });
  const std::vector<double> expected = fold_heights(fur.view());
  EXPECT_GT(count_folds(fur.view()), 10u);
  EXPECT_LT(count_folds(fur.view()), 150u);
  const glm::mat3 turn(glm::rotate(glm::mat4(1), 0.7f, glm::normalize(glm::vec3(1, 2, -0.5f))));
  for (const float scale : {1e-6f, 1.0f, 1e6f}) {
    Furred moved = fur;
    for (std::size_t v = 0; v < fur.positions.size(); ++v) {
      moved.positions[v] = scale * (turn * fur.positions[v]);
      moved.normals[v] = turn * fur.normals[v], moved.tangents[v] = turn * fur.tangents[v];
      moved.length[v] = scale * fur.length[v];
    }
    EXPECT_EQ(fold_heights(moved.view()), expected) << scale;
  }
}

TEST(Folds, DoNotDependOnTheOrderOfTheTriangles) {
  Furred fur = sheet(9, [](glm::dvec2 at) { return glm::dvec2(-2 * at.x * at.x * at.x, 0.6 * at.x * at.y); });
  const std::vector<float> limits = fold_limits(fur.view());
  std::reverse(fur.triangles.begin(), fur.triangles.end());
  for (glm::uvec3& corners : fur.triangles) corners = {corners.y, corners.z, corners.x};
  EXPECT_EQ(fold_limits(fur.view()), limits);
}

TEST(Folds, ExtremesStayFinite) {
  Furred fur = sheet(4, [](glm::dvec2 at) { return -at; });
  fur.positions[0] = fur.positions[1];                                 // triangles without an area
  fur.positions[12] = fur.positions[13] + glm::vec3(1e-7f, 0, 1e-7f);  // slivers
  for (const float length : {0.0f, 1e-6f, 10.0f, 1e6f}) {
    std::fill(fur.length.begin(), fur.length.end(), length);
    for (const double height : fold_heights(fur.view())) EXPECT_TRUE(height > 0 && height <= 2);
    for (const float factor : fold_limits(fur.view())) EXPECT_TRUE(factor >= 0 && factor <= 1);
  }
  fur.triangles.clear();
  EXPECT_EQ(count_folds(fur.view()), 0u);
  EXPECT_EQ(count_folds({}), 0u);
}

}  // namespace
}  // namespace pelage
