#include "renderer/eye/iris_map.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "base/parallel.h"
#include "base/random.h"

namespace pelage {

namespace {

double lattice(int x, int y, int period, std::uint64_t seed) {
  const int wrapped = ((x % period) + period) % period;
  const auto key = (static_cast<std::uint64_t>(wrapped) << 32) ^ static_cast<std::uint32_t>(y) ^ (seed << 20);
  return static_cast<double>(mix_bits(key) >> 11) * 0x1p-53;
}

/// Returns smooth noise in [0, 1] with `period` cells around the axis and `rows` cells along a radius.
double noise(double around, double along, int period, double rows, std::uint64_t seed) {
  const double x = around * period, y = along * rows;
  const double i = std::floor(x), j = std::floor(y);
  const double u = glm::smoothstep(0.0, 1.0, x - i), v = glm::smoothstep(0.0, 1.0, y - j);
  const int a = static_cast<int>(i), b = static_cast<int>(j);
  return glm::mix(glm::mix(lattice(a, b, period, seed), lattice(a + 1, b, period, seed), u),
                  glm::mix(lattice(a, b + 1, period, seed), lattice(a + 1, b + 1, period, seed), u), v);
}

/// Returns lines along the radius that wander a little: 1 on a line, 0 between lines.
double fibres(double around, double along, int period, double wander, std::uint64_t seed) {
  const double bent = around + wander * (noise(around, along, period / 4, 3, seed + 1) - 0.5) / period;
  const double ridge = 1 - std::abs(2 * noise(bent, along, period, 2.5, seed) - 1);
  return ridge * ridge;
}

struct Tissue {
  double scattering, height, inner;
};

/// Returns the tissue at a position: stroma of coarse and fine fibres with crypts between them, the raised collarette,
/// furrows where the iris folds as the pupil opens, and a dark margin on both sides.
Tissue tissue(double around, double along) {
  const double edge = 0.30 + 0.10 * (noise(around, 0, 24, 1, 11) - 0.5) + 0.04 * (noise(around, 0, 90, 1, 12) - 0.5);
  const double outside = glm::smoothstep(-0.03, 0.03, along - edge);
  const double collarette = std::exp(-std::pow((along - edge) / 0.035, 2.0));
  const double coarse = fibres(around, along, 88, 3.0, 21), fine = fibres(around, along, 232, 2.0, 31);
  const double hair = fibres(around, along, 480, 2.0, 41);
  const double crypt =
      outside * glm::smoothstep(0.66, 0.95, noise(around, along, 44, 4.5, 51)) * glm::smoothstep(0.95, 0.75, along);
  const double furrow = outside * std::pow(std::sin(along * 26 + 3 * noise(around, along, 12, 2, 61)), 8.0);
  const double strands = 0.48 * coarse + 0.34 * fine + 0.18 * hair;
  const double margin = glm::smoothstep(0.0, 0.06, along) * glm::smoothstep(1.02, 0.86, along);
  const double blotch = noise(around, along, 14, 2.0, 71);
  Tissue made;
  made.scattering = (0.10 + 0.85 * strands + 0.20 * collarette + 0.16 * (blotch - 0.5) - 0.08 * furrow) *
                    (1 - 0.45 * crypt) * glm::mix(0.25, 1.0, margin);
  made.height = glm::mix(0.55, 0.72, collarette) + 0.40 * (strands - 0.4) - 0.40 * crypt - 0.12 * furrow -
                0.20 * glm::smoothstep(0.75, 1.0, along);
  made.inner = glm::smoothstep(0.75, 0.05, along + 0.35 * (blotch - 0.5) + 0.20 * (strands - 0.4));
  return made;
}

/// Returns thin branching lines that run towards the iris and fade out before it.
double vessels(double around, double along) {
  const auto line = [&](int period, double wander, double width, std::uint64_t seed) {
    const double bent = around + wander * (noise(around, along, period, 7, seed) - 0.5) / period;
    const double off = std::abs(noise(bent, along * 0.6, period, 1.5, seed + 1) - 0.5);
    return glm::smoothstep(width, 0.0, off);
  };
  const double fade = glm::smoothstep(0.02, 0.35, along);
  return fade * std::min(1.0, 0.7 * line(26, 1.6, 0.05, 81) + 0.45 * line(64, 1.8, 0.06, 91));
}

std::uint8_t level(double value) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0))); }

}  // namespace

std::vector<std::uint8_t> make_iris_map() {
  std::vector<std::uint8_t> map(std::size_t{4} * iris_map_width * iris_map_height);
  for_each_in_parallel(iris_map_height, [&](std::uint32_t row) {
    std::uint8_t* to = &map[std::size_t{4} * iris_map_width * row];
    for (int column = 0; column < iris_map_width; ++column) {
      const double around = (column + 0.5) / iris_map_width, along = (row + 0.5) / iris_map_height;
      const Tissue made = tissue(around, along);
      for (const double value : {made.scattering, made.height, made.inner, vessels(around, along)})
        *to++ = level(value);
    }
  });
  return map;
}

}  // namespace pelage
