#include "tests/bench/dial_fit.h"

#include <algorithm>
#include <cmath>

namespace pelage::bench {
namespace {

constexpr double normal_95 = 1.645;  // standard deviations below which 95% of a normal distribution lies
constexpr double pooled_views = 8;   // weight, in views, of the mean spread of all rows within the spread of one row

double at_share(std::vector<double> numbers, double share) {
  std::sort(numbers.begin(), numbers.end());
  const auto index = static_cast<std::size_t>(static_cast<double>(numbers.size()) * share);
  return numbers[std::min(index, numbers.size() - 1)];
}

/// Least squares with x >= 0 by coordinate descent on the normal equations.
void fit_coefficients(DialModel& model, std::span<const MeasuredView> views) {
  constexpr int sweeps = 20'000;
  std::array<std::array<double, cost_terms>, cost_terms> normal{};
  std::array<double, cost_terms> right{};
  for (const MeasuredView& view : views) {
    for (std::size_t row = 0; row < model.rows.size(); ++row) {
      std::array<double, cost_terms> terms = cost_terms_of(view.features, model.rows[row].knobs);
      for (double& term : terms) term /= view.cost_ms[row];
      for (std::size_t i = 0; i < cost_terms; ++i) {
        right[i] += terms[i];
        for (std::size_t j = 0; j < cost_terms; ++j) normal[i][j] += terms[i] * terms[j];
      }
    }
  }
  model.coefficients = {};
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t i = 0; i < cost_terms; ++i) {
      double rest = right[i] + normal[i][i] * model.coefficients[i];
      for (std::size_t j = 0; j < cost_terms; ++j) rest -= normal[i][j] * model.coefficients[j];
      if (normal[i][i] > 0) model.coefficients[i] = std::max(0.0, rest / normal[i][i]);
    }
  }
}

void fit_errors(DialModel& model, std::span<const MeasuredView> views) {
  const double count = static_cast<double>(views.size());
  for (std::size_t row = 0; row < model.rows.size(); ++row) {
    double x = 0, y = 0, xx = 0, xy = 0;
    for (const MeasuredView& view : views) {
      const double fur = std::log(view.features.fur_pixels), error = std::log(view.error[row]);
      x += fur, y += error, xx += fur * fur, xy += fur * error;
    }
    const double growth = (count * xy - x * y) / (count * xx - x * x);
    model.rows[row].growth = growth, model.rows[row].error = std::exp((y - growth * x) / count);
  }
}

void fit_all(DialModel& model, std::span<const MeasuredView> views) {
  model.min_fur = 1e30, model.max_fur = 0;
  for (const MeasuredView& view : views) {
    model.min_fur = std::min(model.min_fur, view.features.fur_pixels);
    model.max_fur = std::max(model.max_fur, view.features.fur_pixels);
  }
  fit_coefficients(model, views), fit_errors(model, views);
}

/// Leave-one-out residuals: logarithms of measured over predicted values, each view by a model fitted without it.
struct Residuals {
  std::vector<double> costs, learnt;         // for each row of each view; `learnt` relative to the view's median
  std::vector<std::vector<double>> squares;  // squared residuals of the errors, by row
};

Residuals residuals_of(const DialModel& fitted, std::span<const MeasuredView> views) {
  Residuals left{{}, {}, std::vector<std::vector<double>>(fitted.rows.size())};
  for (std::size_t out = 0; out < views.size(); ++out) {
    std::vector<MeasuredView> others(views.begin(), views.end());
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(out));
    DialModel model = fitted;
    fit_all(model, others);
    const MeasuredView& view = views[out];
    std::vector<double> costs;
    for (std::size_t row = 0; row < model.rows.size(); ++row) {
      const DialRow& known = model.rows[row];
      costs.push_back(std::log(view.cost_ms[row] / predicted_cost(model, view.features, known.knobs)));
      const double error = std::log(view.error[row] / predicted_error(model, known, view.features));
      left.squares[row].push_back(error * error);
    }
    for (const double cost : costs) left.costs.push_back(cost), left.learnt.push_back(cost - at_share(costs, 0.5));
  }
  return left;
}

double mean(std::span<const double> numbers) {
  double sum = 0;
  for (const double number : numbers) sum += number;
  return sum / static_cast<double>(numbers.size());
}

}  // namespace

DialModel fit(std::span<const Knobs> rows, std::span<const MeasuredView> views) {
  DialModel model;
  for (const Knobs& knobs : rows) model.rows.push_back({.knobs = knobs});
  fit_all(model, views);
  const Residuals left = residuals_of(model, views);
  model.cost_safety = std::exp(std::max(0.0, at_share(left.costs, 0.95)));
  model.learnt_safety = std::exp(std::max(0.0, at_share(left.learnt, 0.95)));
  std::vector<double> spreads;
  for (const std::vector<double>& squares : left.squares) spreads.push_back(mean(squares));
  const double count = static_cast<double>(views.size()), pooled = mean(spreads);
  for (std::size_t row = 0; row < spreads.size(); ++row) {
    const double spread = (spreads[row] * count + pooled * pooled_views) / (count + pooled_views);
    model.rows[row].safety = std::exp(normal_95 * std::sqrt(spread));
  }
  return model;
}

}  // namespace pelage::bench
