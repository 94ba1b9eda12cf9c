// FLIP between two pictures, over the pixels where either shows something.
#pragma once

#include "renderer/compare/compare.h"

namespace pelage::testing {

/// Mean FLIP; 1 if it cannot be measured.
inline double flip_between(const Image& truth, const Image& image) {
  const FloatImage expected = linear_image(truth), drawn = linear_image(image);
  const Result<PictureError> error = compare(expected, drawn, union_of(alpha_mask(expected), alpha_mask(drawn)));
  return error && error->figures ? error->figures->flip.mean : 1;
}

}  // namespace pelage::testing
