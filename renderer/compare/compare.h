// The measure of a picture: how far a picture of fur is from a reference (science.md 6).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "protocol/base/status.h"
#include "protocol/commands/frame.h"
#include "renderer/compare/mask.h"
#include "renderer/image/float_image.h"

namespace pelage {

struct CompareOptions {
  double pixels_per_degree = 67;       // [5, 1000]; .7 m before a screen of .7 m and 3840 pixels
  ToneMap tone_map = ToneMap::filmic;  // before FLIP, of pictures that are not display referred
  double background = 0.18;            // linear grey in [0, 1] behind both pictures
  double outline = 8;                  // pixels to each side of the mask's edge, [0, 1000]
  int threads = 0;                     // 0: as many as there are processors; no figure depends on it
};

/// Mean and 95th percentile (nearest rank) of FLIP over some pixels, both in [0, 1].
struct FlipFigures {
  double mean = 0, percentile_95 = 0;
};

/// Figures over the mask. All but FLIP are in linear light over the background, without tone map; they say nothing
/// where only one of the pictures is display referred.
struct PictureFigures {
  FlipFigures flip;
  std::optional<FlipFigures> outline;  // none where the mask has no edge in the picture
  double rel_mse = 0;                  // mean of (test - reference)^2 / (reference^2 + .01) (Rousselle et al. 2011)
  double rmse = 0;                     // root of the mean square over pixels and R, G, B
  double bias = 0;                     // mean luminance of the test less that of the reference
  double reference_luminance = 0;      // mean
};

struct PictureError {
  std::size_t pixels = 0;                 // in the mask
  double coverage = 0;                    // their share of the picture
  std::size_t non_finite = 0;             // pixels of the whole picture with NaN or infinity in either one
  std::optional<PictureFigures> figures;  // none unless every pixel is finite
  std::vector<float> flip;                // the error map, one for each pixel, rows from the top; empty without figures
};

/// What FLIP looks at, in linear light: as the resolve pass does it, the colour itself is tone mapped, then laid over the
/// background.
FloatImage as_displayed(const FloatImage& image, const CompareOptions& options);

/// Refused (invalid) when sizes differ, the mask is empty, or an option is out of its range.
Result<PictureError> compare(const FloatImage& reference, const FloatImage& test, const Mask& mask,
                             const CompareOptions& options = {});

Result<PictureError> compare(const Image& reference, const Image& test, const Mask& mask,
                             const CompareOptions& options = {});

}  // namespace pelage
