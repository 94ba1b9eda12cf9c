#include "renderer/shading/quadrature.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace pelage {

namespace {

struct Legendre {
  double value = 0;
  double slope = 0;
};

/// P_n(x) and its derivative for |x| < 1, by the three-term recurrence.
Legendre legendre(int n, double x) {
  double before = 0, value = 1;
  for (int k = 1; k <= n; ++k) {
    const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
    before = value;
    value = next;
  }
  return {value, n * (x * value - before) / (x * x - 1)};
}

}  // namespace

std::vector<QuadratureNode> gauss_legendre(int count, double from, double to) {
  assert(count >= 1);
  const double middle = (from + to) / 2, half = (to - from) / 2;
  std::vector<QuadratureNode> nodes;
  nodes.reserve(static_cast<std::size_t>(count));
  for (int i = count - 1; i >= 0; --i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5));  // near the root; Newton does the rest
    for (int step = 0; step < 4; ++step) {
      const Legendre p = legendre(count, x);
      x -= p.value / p.slope;
    }
    const double slope = legendre(count, x).slope;
    nodes.push_back({middle + half * x, half * 2 / ((1 - x * x) * slope * slope)});
  }
  return nodes;
}

}  // namespace pelage
