// Comparison of two pictures: the colour spaces of LDR-FLIP, masks, and error figures.
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

/// Converts to the linearised opponent space of Zhang and Wandell (1996): Y in [-16, 100], Cx red against green, Cz
/// blue against yellow.
glm::dvec3 ycxcz_from_linear(const glm::dvec3& linear);

/// Converts back, clamped to the colours that a display can show.
glm::dvec3 linear_from_ycxcz(const glm::dvec3& ycxcz);

/// Converts to CIE L*a*b* with a and b scaled by L / 100 (Hunt effect: colourfulness grows with luminance; Andersson et
/// al. 2020, eq. 5).
glm::dvec3 hunt_lab_from_linear(const glm::dvec3& linear);

/// Returns |dL| + |(da, db)| (Abasi et al. 2020), a distance for large colour differences.
double hyab(const glm::dvec3& first, const glm::dvec3& second);

// Masks: the fur in a picture, and the band around its silhouette.

/// One byte for each pixel, rows from the top: 1 inside, 0 outside.
struct Mask {
  int width = 0, height = 0;
  std::vector<std::uint8_t> inside;

  std::size_t count() const;
};

/// Returns where alpha is at least 1/255, the least that eight bits can show. NaN is outside.
Mask alpha_mask(const FloatImage& image);

/// Returns where the premultiplied luminance is more than that of sRGB 0.5; for masks drawn as pictures.
Mask luminance_mask(const FloatImage& image);

/// Returns the union of two masks of the same size.
Mask union_of(const Mask& first, const Mask& second);

/// Returns the pixels whose centre is at most `pixels` from the centre of a pixel on the other side of the mask's edge.
/// The picture's border is not an edge. `pixels` in [0, 1000].
Mask silhouette_band(const Mask& mask, double pixels);

// Pictures of the error.

/// Returns errors in [0, 1] as 8-bit colours from black over purple and orange to pale yellow, perceptually uniform:
/// within .013 of matplotlib's `magma`. Values outside [0, 1] are clamped, NaN counts as 1.
Image error_picture(const std::vector<float>& errors, int width, int height);

// The error of a picture of fur against a reference (science.md 6).

struct CompareOptions {
  double pixels_per_degree = 67;       // [5, 1000]; the default is a 3840-pixel screen .7 m wide, .7 m away
  ToneMap tone_map = ToneMap::filmic;  // applied before FLIP to pictures that are not display referred
  double background = 0.18;            // linear grey behind both pictures, [0, 1]
  double silhouette = 8;               // pixels to each side of the mask's edge, [0, 1000]
  int threads = 0;                     // 0: one for each processor; does not change the result
};

/// Mean and 95th percentile (nearest rank) of FLIP over a set of pixels, both in [0, 1].
struct FlipFigures {
  double mean = 0, percentile_95 = 0;
};

/// Figures over the mask. All except FLIP are in linear light over the background, without tone mapping; they are
/// meaningless if only one of the pictures is display referred.
struct PictureFigures {
  FlipFigures flip;
  std::optional<FlipFigures> silhouette;  // none if the mask has no edge in the picture
  double rel_mse = 0;                     // mean of (test - reference)^2 / (reference^2 + .01) (Rousselle et al. 2011)
  double rmse = 0;                        // root of the mean square over pixels and R, G, B
  double bias = 0;                        // mean luminance of the test less that of the reference
  double reference_luminance = 0;         // mean luminance of the reference
};

struct PictureError {
  std::size_t pixels = 0;                 // number of pixels in the mask
  double coverage = 0;                    // share of the picture in the mask
  std::size_t non_finite = 0;             // pixels of the whole picture with NaN or infinity in either one
  std::optional<PictureFigures> figures;  // none if any pixel is not finite
  std::vector<float> flip;                // the error map, one for each pixel, rows from the top; empty without figures
};

/// Returns the displayed picture that FLIP compares, in linear light. As in renderer/finish, the unpremultiplied colour
/// is tone mapped and then laid over the background.
FloatImage as_displayed(const FloatImage& image, const CompareOptions& options);

/// Compares two pictures. Fails with invalid if sizes differ, the mask is empty, or an option is out of range.
Result<PictureError> compare(const FloatImage& reference, const FloatImage& test, const Mask& mask,
                             const CompareOptions& options = {});

}  // namespace pelage
