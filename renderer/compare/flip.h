// LDR-FLIP (Andersson et al. 2020): its separable filter kernels (4.1.1, 4.2) and the error map of two pictures.
#pragma once

#include <vector>

#include "renderer/image/float_image.h"

namespace pelage {

/// An odd number of weights; the middle one is the pixel itself.
using Kernel = std::vector<double>;

inline int radius_of(const Kernel& kernel) { return static_cast<int>(kernel.size() / 2); }

struct FlipKernels {
  /// The contrast sensitivity of the eye. Luminance and red against green sum to 1. Blue against yellow is the sum of a
  /// narrow and a wide Gaussian; the squares of their sums add up to 1.
  Kernel luminance, red_green, blue_yellow_narrow, blue_yellow_wide;
  /// A Gaussian with the width of perceived edges and points, and its first and second derivative; the positive and
  /// negative weights of a derivative sum to 1 and -1.
  Kernel smooth, edge, point;

  /// Returns the largest radius.
  int reach() const;
};

/// `pixels_per_degree`: pixels for each degree of visual angle, [5, 1000].
FlipKernels flip_kernels(double pixels_per_degree);

// LDR-FLIP: how different two pictures look when they are swapped in place.
// Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild: FLIP, A Difference Evaluator for Alternating
// Images, Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020.

/// Returns the error of each pixel in [0, 1], rows from the top. Both pictures have the same size and hold linear RGB
/// in [0, 1], as a display shows it; alpha is ignored. Pixels beyond the border repeat the outermost ones. Equal
/// pictures give exactly 0. The result does not depend on `threads`; 0 stands for one for each processor.
std::vector<float> flip_map(const FloatImage& reference, const FloatImage& test, double pixels_per_degree,
                            int threads = 0);

}  // namespace pelage
