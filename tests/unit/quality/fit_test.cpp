// A fit finds the prices and errors that measurements were made from.
#include "renderer/quality/fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/quality/cost_model.h"
#include "renderer/quality/error_model.h"
#include "tests/unit/quality/views.h"

namespace pelage {
namespace {

using testing::frame_of;
using testing::Patch;

std::vector<Knobs> ladder() {
  std::vector<Knobs> knobs;
  for (const CalibratedKnobs& row : testing::plain_calibration().ladder) knobs.push_back(row.knobs);
  return knobs;
}

/// Views whose costs are the plain prices' and whose errors fall with shells and rise with the fur's pixels.
std::vector<MeasuredView> measured() {
  const Calibration truth = testing::plain_calibration();
  std::vector<MeasuredView> views;
  for (const int cells : {4, 16, 40}) {
    for (const float fur : {0.01f, 0.04f}) {
      for (const int size : {128, 256, 700}) {
        const Patch patch(cells, 0.3f, fur);
        MeasuredView view{.features = view_features(frame_of(size, size), patch.skin()), .cost_ms = {}, .error = {}};
        for (const Knobs& knobs : ladder()) {
          view.cost_ms.push_back(predicted_cost(truth, view.features, knobs));
          view.error.push_back(0.2 / knobs.shells * std::pow(view.features.fur_pixels, 0.3));
        }
        views.push_back(view);
      }
    }
  }
  return views;
}

TEST(Fit, LeastSquaresStayAboveZero) {
  // x = (2, 3) exactly; then a column that only hurts.
  const double a[] = {1, 0, 0, 1, 1, 1}, b[] = {2, 3, 5};
  const auto x = least_squares_above_zero(a, b, 2);
  EXPECT_NEAR(x[0], 2, 1e-9);
  EXPECT_NEAR(x[1], 3, 1e-9);
  const double c[] = {1, 1, 1, 2, 1, 3}, d[] = {3, 2, 1};
  const auto y = least_squares_above_zero(c, d, 2);
  EXPECT_NEAR(y[0], 2, 1e-9);
  EXPECT_EQ(y[1], 0);
}

TEST(Fit, CostsAndErrorsComeBack) {
  const std::vector<MeasuredView> views = measured();
  const Calibration calibration = fit_calibration(ladder(), views);
  for (const MeasuredView& view : views) {
    for (std::size_t row = 0; row < view.error.size(); ++row) {
      EXPECT_NEAR(predicted_cost(calibration, view.features, calibration.ladder[row].knobs) / view.cost_ms[row], 1,
                  0.05);
      const ErrorTraits traits = in_range(calibration, error_traits_of(view.features));
      EXPECT_NEAR(std::log(predicted_error(calibration.ladder[row], traits) / view.error[row]), 0, 0.4);
      EXPECT_GT(calibration.ladder[row].slopes[0], 0.05);  // longer fur is further off
    }
  }
  for (const double price : calibration.cost) EXPECT_GE(price, 0);
  EXPECT_LT(calibration.cost_safety, 1.2);
  EXPECT_LT(calibration.ladder.front().error_safety, 1.6);
}

TEST(Fit, SafetyGrowsWithWhatFeaturesDoNotPredict) {
  std::vector<MeasuredView> views = measured();
  const Calibration calm = fit_calibration(ladder(), views);
  for (std::size_t i = 0; i < views.size(); i += 2) {
    for (double& cost : views[i].cost_ms) cost *= 1.6;
    for (double& error : views[i].error) error *= 1.6;
  }
  const Calibration wild = fit_calibration(ladder(), views);
  EXPECT_GT(wild.cost_safety, calm.cost_safety * 1.1);
  EXPECT_GT(wild.ladder[2].error_safety, calm.ladder[2].error_safety * 1.1);
}

TEST(Fit, CostsAloneLeaveErrors) {
  std::vector<MeasuredView> views = measured();
  const Calibration before = fit_calibration(ladder(), views);
  for (MeasuredView& view : views) {
    for (double& cost : view.cost_ms) cost *= 2;
    view.error.clear();
  }
  const Calibration after = fit_costs(before, views);
  EXPECT_NEAR(predicted_cost(after, views[0].features, ladder()[0]) / views[0].cost_ms[0], 1, 0.05);
  EXPECT_EQ(after.ladder[1].log_error, before.ladder[1].log_error);
}

TEST(Fit, FewViewsDoNotLowerTheSafety) {
  const std::vector<MeasuredView> views = measured();
  Calibration before = fit_calibration(ladder(), views);
  before.cost_safety = 1.9;
  EXPECT_EQ(fit_costs(before, std::span(views).first(4)).cost_safety, 1.9);
  EXPECT_LT(fit_costs(before, views).cost_safety, 1.9);
}

TEST(Fit, RowsThatAreNeverBestAreLeftOut) {
  MeasuredView view;
  view.cost_ms = {1, 2, 3, 4}, view.error = {.1, .2, .05, .05};
  const std::vector<MeasuredView> views{view};
  EXPECT_EQ(pareto_rows(views), (std::vector<std::size_t>{0, 2}));
}

}  // namespace
}  // namespace pelage
