// A picture of where the error is.
#pragma once

#include <vector>

#include "renderer/image/image.h"

namespace pelage {

/// Errors in [0, 1] as 8-bit colours from black over purple and orange to pale yellow, even to the eye: within .013 of
/// matplotlib's `magma`. Outside [0, 1] the ends are taken, NaN is taken as 1.
Image error_picture(const std::vector<float>& errors, int width, int height);

}  // namespace pelage
