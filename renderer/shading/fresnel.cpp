#include "renderer/shading/fresnel.h"

#include <cassert>
#include <cmath>

namespace pelage {

double fresnel_dielectric(double cos_incidence, double eta) {
  assert(eta >= 1);
  if (!(cos_incidence > 0)) return 1;
  const double squared = eta * eta - 1 + cos_incidence * cos_incidence;  // (eta cos of the refracted angle)^2
  const double inside = std::sqrt(squared) / eta;
  const double parallel = (eta * cos_incidence - inside) / (eta * cos_incidence + inside);
  const double across = (cos_incidence - eta * inside) / (cos_incidence + eta * inside);
  return (parallel * parallel + across * across) / 2;
}

}  // namespace pelage
