// LDR-FLIP: how different two pictures look when they are swapped in place.
// Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild: FLIP, A Difference Evaluator for Alternating
// Images, Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020.
#pragma once

#include <vector>

#include "renderer/image/float_image.h"

namespace pelage {

/// The error of each pixel in [0, 1], rows from the top. Both pictures have one size and hold linear RGB in [0, 1], as
/// a display shows it; alpha is not looked at. At the border the outermost pixels are repeated. Equal pictures give
/// exactly 0. The bits do not depend on `threads`; 0 stands for as many as there are processors.
std::vector<float> flip_map(const FloatImage& reference, const FloatImage& test, double pixels_per_degree,
                            int threads = 0);

}  // namespace pelage
