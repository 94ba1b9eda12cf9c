#pragma once

#include <vector>

namespace pelage {

struct QuadratureNode {
  double x = 0;
  double weight = 0;
};

/// Gauss-Legendre nodes for the integral over [from, to]: exact for polynomials of degree 2 count - 1. `count` >= 1.
std::vector<QuadratureNode> gauss_legendre(int count, double from, double to);

}  // namespace pelage
