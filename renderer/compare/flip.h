// LDR-FLIP (Andersson et al. 2020): its separable filter kernels (4.1.1, 4.2) and the error map of two pictures.
#pragma once

#include <vector>

#include "renderer/image/float_image.h"

namespace pelage {

/// An odd number of weights; the middle one is the pixel itself.
using Kernel = std::vector<double>;

inline int radius_of(const Kernel& kernel) { return static_cast<int>(kernel.size() / 2); }

struct FlipKernels {
  /// The eye's contrast sensitivity: luminance and red against green sum to 1. That of blue against yellow is the sum
  /// of a narrow and a wide Gaussian, and the sums of their squares add up to 1.
  Kernel luminance, red_green, blue_yellow_narrow, blue_yellow_wide;
  /// A Gaussian as wide as what the eye takes for an edge or a point, and its first and second derivative; the positive
  /// and the negative weights of a derivative sum to 1 and -1.
  Kernel smooth, edge, point;

  /// The largest radius.
  int reach() const;
};

/// `pixels_per_degree` in [5, 1000]: of the visual angle.
FlipKernels flip_kernels(double pixels_per_degree);

// LDR-FLIP: how different two pictures look when they are swapped in place.
// Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild: FLIP, A Difference Evaluator for Alternating
// Images, Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020.

/// The error of each pixel in [0, 1], rows from the top. Both pictures have one size and hold linear RGB in [0, 1], as
/// a display shows it; alpha is not looked at. At the border the outermost pixels are repeated. Equal pictures give
/// exactly 0. The bits do not depend on `threads`; 0 stands for as many as there are processors.
std::vector<float> flip_map(const FloatImage& reference, const FloatImage& test, double pixels_per_degree,
                            int threads = 0);

}  // namespace pelage
