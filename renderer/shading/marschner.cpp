#include "renderer/shading/marschner.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "renderer/shading/fibre.h"

namespace pelage {

namespace {

using std::numbers::pi;

constexpr int node_count = 192;
constexpr double min_width = 0.02;

/// Returns nodes in h. With h = sin gamma, azimuths are smooth functions of gamma, also at the fibre's edge.
std::vector<QuadratureNode> offset_nodes() {
  std::vector<QuadratureNode> nodes = gauss_legendre(node_count, 0, pi / 2);
  for (QuadratureNode& node : nodes) node = {std::sin(node.x), node.weight * std::cos(node.x)};
  return nodes;
}

double gaussian(double x, double width) { return std::exp(-x * x / (2 * width * width)) / (width * std::sqrt(2 * pi)); }

}  // namespace

AzimuthalAverage::AzimuthalAverage(ShadingModel shading, const FibreOptics& fibre)
    : marschner_(shading == ShadingModel::marschner),
      eta_(fibre.refractive_index),
      width_(marschner_ ? fibre.caustic_width * pi / 180 : azimuthal_scale(fibre.azimuthal_roughness)),
      nodes_(offset_nodes()) {
  assert(marschner_ || shading == ShadingModel::energy_conserving);
  width_ = std::max(width_, min_width);
  share_ = marschner_ ? std::erf(pi / (width_ * std::sqrt(2.0))) : logistic_share(width_);
}

double AzimuthalAverage::distribution(double apart) const {
  const double wrapped = wrapped_angle(apart);
  return (marschner_ ? gaussian(wrapped, width_) : logistic(wrapped, width_)) / share_;
}

AzimuthalAverage::NodeValues AzimuthalAverage::exits(double cos_theta) const {
  NodeValues values(nodes_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    for (int p = 0; p + 1 < lobe_count; ++p) {
      values[i][static_cast<std::size_t>(p)] = exit_azimuth(p, nodes_[i].x, cos_theta, eta_);
    }
  }
  return values;
}

/// Rays at h and -h leave at opposite azimuths with the same strength.
AzimuthalAverage::NodeValues AzimuthalAverage::spread(const NodeValues& exits, double azimuth) const {
  NodeValues values(nodes_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    for (std::size_t p = 0; p + 1 < lobe_count; ++p) {
      const double both = distribution(azimuth - exits[i][p]) + distribution(azimuth + exits[i][p]);
      values[i][p] = nodes_[i].weight / 2 * both;
    }
    values[i][lobe_count - 1] = nodes_[i].weight / (2 * pi);
  }
  return values;
}

AzimuthalAverage::NodeValues AzimuthalAverage::passed(double cos_theta, double sigma_a) const {
  NodeValues values(nodes_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) values[i] = attenuation(cos_theta, nodes_[i].x, sigma_a, eta_);
  return values;
}

LobeValues AzimuthalAverage::sum(const NodeValues& spread, const NodeValues& passed, double cos_theta,
                                 double azimuth) const {
  LobeValues total{};
  for (std::size_t i = 0; i < spread.size(); ++i) {
    for (std::size_t p = 0; p < lobe_count; ++p) total[p] += spread[i][p] * passed[i][p];
  }
  if (!marschner_) return total;
  return {marschner_reflection(cos_theta, azimuth, eta_), total[1], total[2], 0};
}

MarschnerLobes marschner_lobes(const FibreOptics& fibre) {
  const double alpha = fibre.cuticle_tilt * pi / 180, beta = fibre.highlight_width * pi / 180;
  const auto width = [](double wanted) { return std::max(wanted, 1e-3); };
  return {{alpha, -alpha / 2, -1.5 * alpha, 0},
          {width(beta), width(beta / 2), width(2 * beta), 1},
          fibre.caustic_width * pi / 180,
          fibre.refractive_index};
}

double marschner_reflection(double cos_theta_d, double azimuth, double eta) {
  const double cos_gamma = std::max(0.0, std::cos(azimuth / 2));
  return cos_gamma / 4 * fresnel_dielectric(cos_theta_d * cos_gamma, eta);
}

}  // namespace pelage
