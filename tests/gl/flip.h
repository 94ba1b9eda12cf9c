// How far two pictures are from each other where either shows something.
#pragma once

#include "renderer/compare/compare.h"

namespace pelage::testing {

/// Mean FLIP; 1 where it cannot be measured.
inline double flip_between(const Image& truth, const Image& image) {
  const Mask mask = union_of(alpha_mask(linear_image(truth)), alpha_mask(linear_image(image)));
  const Result<PictureError> error = compare(truth, image, mask);
  return error && error->figures ? error->figures->flip.mean : 1;
}

}  // namespace pelage::testing
