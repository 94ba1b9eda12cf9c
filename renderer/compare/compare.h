// The comparison of two pictures: LDR-FLIP's colour spaces, masks, and the figures of the error.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "base/status.h"
#include "protocol/commands/frame.h"
#include "renderer/image/float_image.h"
#include "renderer/image/image.h"

namespace pelage {

/// The linearised opponent space of Zhang and Wandell (1996): Y in [-16, 100], Cx red against green, Cz blue against
/// yellow.
glm::dvec3 ycxcz_from_linear(const glm::dvec3& linear);

/// Back, held to the colours that a display has.
glm::dvec3 linear_from_ycxcz(const glm::dvec3& ycxcz);

/// CIE L*a*b* with a and b scaled by L / 100 (Hunt: colourfulness grows with luminance; Andersson et al. 2020, eq. 5).
glm::dvec3 hunt_lab_from_linear(const glm::dvec3& linear);

/// |dL| + |(da, db)| (Abasi et al. 2020), for large differences of colour.
double hyab(const glm::dvec3& first, const glm::dvec3& second);

// Where fur is in a picture, and the band around its silhouette.

/// One byte for each pixel, rows from the top: 1 inside, 0 outside.
struct Mask {
  int width = 0, height = 0;
  std::vector<std::uint8_t> inside;

  std::size_t count() const;
};

/// Where alpha is at least 1/255: what eight bits can show. NaN is outside.
Mask alpha_mask(const FloatImage& image);

/// Where the picture is brighter than half, times alpha: for masks drawn as pictures.
Mask luminance_mask(const FloatImage& image);

/// Inside either of two masks of one size.
Mask union_of(const Mask& first, const Mask& second);

/// Pixels whose centre lies at most `pixels` from that of a pixel on the other side of the mask's edge. The picture's
/// border is no edge. `pixels` in [0, 1000].
Mask silhouette_band(const Mask& mask, double pixels);

// A picture of where the error is.

/// Errors in [0, 1] as 8-bit colours from black over purple and orange to pale yellow, even to the eye: within .013 of
/// matplotlib's `magma`. Outside [0, 1] the ends are taken, NaN is taken as 1.
Image error_picture(const std::vector<float>& errors, int width, int height);

// The measure of a picture: how far a picture of fur is from a reference (science.md 6).

struct CompareOptions {
  double pixels_per_degree = 67;       // [5, 1000]; .7 m before a screen of .7 m and 3840 pixels
  ToneMap tone_map = ToneMap::filmic;  // before FLIP, of pictures that are not display referred
  double background = 0.18;            // linear grey in [0, 1] behind both pictures
  double silhouette = 8;               // pixels to each side of the mask's edge, [0, 1000]
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
  std::optional<FlipFigures> silhouette;  // none where the mask has no edge in the picture
  double rel_mse = 0;                     // mean of (test - reference)^2 / (reference^2 + .01) (Rousselle et al. 2011)
  double rmse = 0;                        // root of the mean square over pixels and R, G, B
  double bias = 0;                        // mean luminance of the test less that of the reference
  double reference_luminance = 0;         // mean
};

struct PictureError {
  std::size_t pixels = 0;                 // in the mask
  double coverage = 0;                    // their share of the picture
  std::size_t non_finite = 0;             // pixels of the whole picture with NaN or infinity in either one
  std::optional<PictureFigures> figures;  // none unless every pixel is finite
  std::vector<float> flip;                // the error map, one for each pixel, rows from the top; empty without figures
};

/// What FLIP looks at, in linear light: as renderer/finish does it, the colour itself is tone mapped, then laid over
/// the background.
FloatImage as_displayed(const FloatImage& image, const CompareOptions& options);

/// Refused (invalid) when sizes differ, the mask is empty, or an option is out of its range.
Result<PictureError> compare(const FloatImage& reference, const FloatImage& test, const Mask& mask,
                             const CompareOptions& options = {});

}  // namespace pelage
