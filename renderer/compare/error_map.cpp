#include "renderer/compare/error_map.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace pelage {

namespace {

/// sRGB at tenths: a least squares fit of straight lines to magma.
constexpr std::array<std::array<double, 3>, 11> ramp = {{{0.000, 0.000, 0.004},
                                                         {0.073, 0.061, 0.215},
                                                         {0.231, 0.059, 0.450},
                                                         {0.395, 0.098, 0.508},
                                                         {0.549, 0.163, 0.507},
                                                         {0.713, 0.212, 0.481},
                                                         {0.874, 0.281, 0.408},
                                                         {0.973, 0.432, 0.349},
                                                         {0.997, 0.626, 0.421},
                                                         {0.997, 0.809, 0.567},
                                                         {0.987, 0.992, 0.748}}};

}  // namespace

Image error_picture(const std::vector<float>& errors, int width, int height) {
  assert(errors.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  Image picture{width, height, {}};
  picture.rgba.reserve(errors.size() * 4);
  for (float error : errors) {
    const double place = (std::isnan(error) ? 1.0 : std::clamp(static_cast<double>(error), 0.0, 1.0)) * 10;
    const std::size_t below = std::min<std::size_t>(static_cast<std::size_t>(place), 9);
    const double share = place - static_cast<double>(below);
    for (std::size_t k = 0; k < 3; ++k) {
      const double value = ramp[below][k] + share * (ramp[below + 1][k] - ramp[below][k]);
      picture.rgba.push_back(static_cast<std::uint8_t>(std::lround(value * 255)));
    }
    picture.rgba.push_back(255);
  }
  return picture;
}

}  // namespace pelage
