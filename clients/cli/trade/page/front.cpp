#include "clients/cli/trade/page/front.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace pelage::trade {

namespace {

std::vector<std::string> scenes_of(const std::vector<Row>& rows, bool only_swept) {
  std::vector<std::string> scenes;
  for (const Row& row : rows) {
    const bool wanted = !only_swept || row.series == "grid";
    if (wanted && std::find(scenes.begin(), scenes.end(), row.scene) == scenes.end()) scenes.push_back(row.scene);
  }
  return scenes;
}

}  // namespace

double cost_of(const Row& row) { return row.cpu_ms > 0 ? row.cpu_ms : row.draw_ms; }

std::string milliseconds(double value) {
  return value >= 100 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

bool against_shells(const Row& row) { return row.reference.starts_with("R1"); }

std::string name_of(const Row& row) {
  if (row.series == "tier") return row.value;
  if (row.series == "grid")
    return fmt::format("{} shells of {} steps at {:g} of the size", row.shells, row.steps, row.scale);
  return fmt::format("{} with {} {}", row.base, row.series, row.value);
}

std::vector<std::size_t> pareto_front(const std::vector<double>& costs, const std::vector<double>& errors) {
  std::vector<std::size_t> order(costs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return costs[a] != costs[b] ? costs[a] < costs[b] : errors[a] < errors[b];
  });
  std::vector<std::size_t> front;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order) {
    if (!(errors[i] < least)) continue;
    front.push_back(i);
    least = errors[i];
  }
  return front;
}

std::vector<Mean> means_over(const std::vector<Row>& rows, const std::vector<std::string>& scenes) {
  const std::set<std::string> wanted(scenes.begin(), scenes.end());
  std::vector<Mean> means;
  std::map<std::string, std::size_t> place;
  std::set<std::pair<std::string, std::string>> seen;
  for (const Row& row : rows) {
    if (!against_shells(row) || !wanted.contains(row.scene) || !seen.emplace(row.scene, row.knobs).second) continue;
    const auto [found, added] = place.emplace(row.knobs, means.size());
    if (added) means.push_back({.name = name_of(row), .knobs = row.knobs});
    Mean& mean = means[found->second];
    mean.cost += std::log(std::max(cost_of(row), 1e-3));
    mean.flip += row.flip, mean.outline += row.outline, ++mean.scenes;
  }
  for (Mean& mean : means) {
    mean.cost = std::exp(mean.cost / mean.scenes);
    mean.flip /= mean.scenes, mean.outline /= mean.scenes;
  }
  std::erase_if(means, [&](const Mean& mean) { return mean.scenes != static_cast<int>(wanted.size()); });
  return means;
}

std::vector<std::string> swept_scenes(const std::vector<Row>& rows) { return scenes_of(rows, true); }
std::vector<std::string> all_scenes(const std::vector<Row>& rows) { return scenes_of(rows, false); }

std::optional<double> fitted_order(const std::vector<double>& x, const std::vector<double>& y) {
  const double n = static_cast<double>(x.size());
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double u = std::log(x[i]), v = std::log(y[i]);
    sx += u, sy += v, sxx += u * u, sxy += u * v;
  }
  const double spread = n * sxx - sx * sx;
  if (!(spread > 1e-12)) return std::nullopt;
  return -(n * sxy - sx * sy) / spread;
}

}  // namespace pelage::trade
