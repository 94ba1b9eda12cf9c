#include "renderer/quality/fit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <numeric>

#include "renderer/quality/cost_model.h"
#include "renderer/quality/error_model.h"

namespace pelage {

namespace {

constexpr double ridge = 3;          // on slopes; for 13 views .3 gave a spread of .41, 1 of .36, 3 of .35
constexpr double normal_95 = 1.645;  // standard deviations below which 95% of a normal distribution lies
constexpr double pooled_views = 8;   // that the spread of all rows counts as in the spread of one
constexpr int sweeps = 20'000;       // of coordinate descent
constexpr double max_safety = 4;
constexpr std::size_t enough_views = 12;  // fewer judge their own fit too kindly

/// Solves a symmetric positive definite system by Cholesky's decomposition.
template <std::size_t N>
std::array<double, N> solve(std::array<std::array<double, N>, N> a, std::array<double, N> b) {
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = a[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= a[i][k] * a[j][k];
      a[i][j] = i == j ? std::sqrt(std::max(sum, 1e-12)) : sum / a[j][j];
    }
    for (std::size_t k = 0; k < i; ++k) b[i] -= a[i][k] * b[k];
    b[i] /= a[i][i];
  }
  for (std::size_t i = N; i-- > 0;) {
    for (std::size_t k = i + 1; k < N; ++k) b[i] -= a[k][i] * b[k];
    b[i] /= a[i][i];
  }
  return b;
}

using Chosen = std::function<bool(const MeasuredView&)>;

double log_error(double error) { return std::log(std::max(error, min_error)); }

/// One row's line over the views that are chosen.
CalibratedKnobs fit_row(const Calibration& calibration, const Knobs& knobs, std::size_t row,
                        std::span<const MeasuredView> views, const Chosen& chosen) {
  constexpr std::size_t n = error_traits + 1;
  std::array<std::array<double, n>, n> normal{};
  std::array<double, n> right{};
  for (std::size_t i = 0; i < n; ++i) normal[i][i] = i == 0 ? 1e-9 : ridge;
  for (const MeasuredView& view : views) {
    if (!chosen(view)) continue;
    const ErrorTraits traits = in_range(calibration, error_traits_of(view.features));
    std::array<double, n> x{1};
    for (std::size_t i = 0; i < error_traits; ++i) x[i + 1] = traits[i] - 0.5;  // so that the ridge draws to the middle
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) normal[i][j] += x[i] * x[j];
      right[i] += x[i] * log_error(view.error[row]);
    }
  }
  const std::array<double, n> solved = solve(normal, right);
  CalibratedKnobs result{.knobs = knobs, .log_error = solved[0]};
  for (std::size_t i = 0; i < error_traits; ++i) {
    result.slopes[i] = solved[i + 1];
    result.log_error -= 0.5 * solved[i + 1];
  }
  return result;
}

std::array<double, cost_terms> fit_cost(std::span<const Knobs> ladder, std::span<const MeasuredView> views,
                                        const Chosen& chosen) {
  std::vector<double> a, b;
  for (const MeasuredView& view : views) {
    if (!chosen(view)) continue;
    for (std::size_t row = 0; row < ladder.size(); ++row) {
      for (const double term : cost_terms_of(view.features, ladder[row])) a.push_back(term / view.cost_ms[row]);
      b.push_back(1);
    }
  }
  const std::vector<double> solved = least_squares_above_zero(a, b, cost_terms);
  std::array<double, cost_terms> result{};
  std::copy(solved.begin(), solved.end(), result.begin());
  return result;
}

void measure_range(Calibration& calibration, std::span<const MeasuredView> views) {
  calibration.low.fill(1e30), calibration.high.fill(-1e30);
  for (const MeasuredView& view : views) {
    const ErrorTraits traits = error_traits_of(view.features);
    for (std::size_t i = 0; i < error_traits; ++i) {
      calibration.low[i] = std::min(calibration.low[i], traits[i]);
      calibration.high[i] = std::max(calibration.high[i], traits[i]);
    }
  }
}

/// Calls `judge(chosen, left_out)` for each view, where there are others.
template <class Judge>
void leave_out_each(std::span<const MeasuredView> views, Judge judge) {
  if (views.size() < 2) return;
  for (const MeasuredView& out : views) {
    judge([&out](const MeasuredView& view) { return &view != &out; }, out);
  }
}

/// What 95% are not above.
double safe(std::vector<double> ratios) {
  std::sort(ratios.begin(), ratios.end());
  return std::clamp(ratios[ratios.size() * 95 / 100], 1.0, max_safety);
}

/// The ratios of an order's rows over their geometric mean.
void add_about_mean(std::span<const Knobs> ladder, std::span<const double> ratios, FragmentOrder order,
                    std::vector<double>& about) {
  double sum = 0;
  int count = 0;
  for (std::size_t row = 0; row < ladder.size(); ++row) {
    if (ladder[row].order == order) sum += std::log(ratios[row]), ++count;
  }
  for (std::size_t row = 0; row < ladder.size(); ++row) {
    if (ladder[row].order == order) about.push_back(ratios[row] / std::exp(sum / count));
  }
}

/// Of scenes of which nothing is learnt, and of those of which it is.
void set_cost_safety(Calibration& calibration, std::span<const Knobs> ladder, std::span<const MeasuredView> views) {
  std::vector<double> all{1}, about{1};
  leave_out_each(views, [&](const Chosen& chosen, const MeasuredView& left_out) {
    Calibration fitted;
    fitted.cost = fit_cost(ladder, views, chosen);
    std::vector<double> ratios;
    for (std::size_t row = 0; row < ladder.size(); ++row)
      ratios.push_back(left_out.cost_ms[row] / predicted_cost(fitted, left_out.features, ladder[row]));
    all.insert(all.end(), ratios.begin(), ratios.end());
    for (const FragmentOrder order : {FragmentOrder::shells, FragmentOrder::sorted})
      add_about_mean(ladder, ratios, order, about);
  });
  calibration.cost_safety = safe(std::move(all));
  calibration.learnt_safety = std::min(safe(std::move(about)), calibration.cost_safety);
}

/// Mean square of what is left of the logarithm of each row's error.
std::vector<double> spreads_of_error(const Calibration& calibration, std::span<const MeasuredView> views) {
  std::vector<double> squares(calibration.ladder.size());
  leave_out_each(views, [&](const Chosen& chosen, const MeasuredView& left_out) {
    const ErrorTraits traits = in_range(calibration, error_traits_of(left_out.features));
    for (std::size_t row = 0; row < squares.size(); ++row) {
      const CalibratedKnobs line = fit_row(calibration, calibration.ladder[row].knobs, row, views, chosen);
      const double left = log_error(left_out.error[row]) - std::log(predicted_error(line, traits));
      squares[row] += left * left / static_cast<double>(views.size());
    }
  });
  return squares;
}

void set_error_safety(Calibration& calibration, std::span<const MeasuredView> views) {
  const std::vector<double> squares = spreads_of_error(calibration, views);
  const double count = static_cast<double>(views.size());
  const double pooled = std::accumulate(squares.begin(), squares.end(), 0.0) / static_cast<double>(squares.size());
  for (std::size_t row = 0; row < squares.size(); ++row) {
    const double spread = (squares[row] * count + pooled * pooled_views) / (count + pooled_views);
    calibration.ladder[row].error_safety = std::clamp(std::exp(normal_95 * std::sqrt(spread)), 1.0, max_safety);
  }
}

double safety_of_probes(std::span<const MeasuredView> views) {
  std::vector<double> ratios{1};
  for (const MeasuredView& view : views) {
    for (std::size_t row = 0; row < view.probed_error.size(); ++row) {
      if (view.probed_error[row] > 0) ratios.push_back(view.error[row] / view.probed_error[row]);
    }
  }
  return safe(std::move(ratios));
}

}  // namespace

std::vector<double> least_squares_above_zero(std::span<const double> a, std::span<const double> b,
                                             std::size_t columns) {
  const std::size_t rows = b.size();
  assert(a.size() == rows * columns);
  std::vector<double> normal(columns * columns), right(columns), x(columns);
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t i = 0; i < columns; ++i) {
      right[i] += a[r * columns + i] * b[r];
      for (std::size_t j = 0; j < columns; ++j) normal[i * columns + j] += a[r * columns + i] * a[r * columns + j];
    }
  }
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t i = 0; i < columns; ++i) {
      const double own = normal[i * columns + i];
      if (!(own > 0)) continue;
      double rest = right[i] + own * x[i];
      for (std::size_t j = 0; j < columns; ++j) rest -= normal[i * columns + j] * x[j];
      x[i] = std::max(0.0, rest / own);
    }
  }
  return x;
}

Calibration fit_calibration(std::span<const Knobs> ladder, std::span<const MeasuredView> views) {
  assert(!views.empty());
  const Chosen all = [](const MeasuredView&) { return true; };
  Calibration calibration;
  measure_range(calibration, views);
  calibration.cost = fit_cost(ladder, views, all);
  for (std::size_t row = 0; row < ladder.size(); ++row)
    calibration.ladder.push_back(fit_row(calibration, ladder[row], row, views, all));
  set_cost_safety(calibration, ladder, views);
  calibration.probe_safety = safety_of_probes(views);
  set_error_safety(calibration, views);
  return calibration;
}

Calibration fit_costs(const Calibration& errors, std::span<const MeasuredView> views) {
  assert(!views.empty());
  std::vector<Knobs> ladder;
  for (const CalibratedKnobs& row : errors.ladder) ladder.push_back(row.knobs);
  Calibration calibration = errors;
  calibration.cost = fit_cost(ladder, views, [](const MeasuredView&) { return true; });
  set_cost_safety(calibration, ladder, views);
  if (views.size() >= enough_views) return calibration;
  calibration.cost_safety = std::max(calibration.cost_safety, errors.cost_safety);
  calibration.learnt_safety = std::max(calibration.learnt_safety, errors.learnt_safety);
  return calibration;
}

std::vector<std::size_t> pareto_rows(std::span<const MeasuredView> views, double slack) {
  assert(!views.empty());
  std::vector<std::size_t> kept;
  for (std::size_t row = 0; row < views.front().error.size(); ++row) {
    const bool good = std::any_of(views.begin(), views.end(), [&](const MeasuredView& view) {
      for (std::size_t other = 0; other < view.error.size(); ++other) {
        if (view.cost_ms[other] < view.cost_ms[row] && view.error[other] <= view.error[row] * slack) return false;
      }
      return true;
    });
    if (good) kept.push_back(row);
  }
  return kept;
}

}  // namespace pelage
