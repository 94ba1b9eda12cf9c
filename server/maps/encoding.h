// A map's picture over [0, 1] x [0, 1] of the texture (drawn by triangles, dilated over seams, fitted), and the
// encoding of field values as numbers in its file.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "protocol/commands/map.h"
#include "server/maps/uv_corners.h"

namespace pelage {

/// A square picture. Rows from the top, v up: pixel (x, y) has its centre at u = (x + .5) / size,
/// v = 1 - (y + .5) / size.
struct MapImage {
  int size = 1;                       // pixels on a side, [1, 8192]
  int channels = 1;                   // [1, 4]
  std::vector<float> values;          // channels * size * size
  std::vector<std::uint8_t> covered;  // size * size: 1 if the pixel's value is drawn or dilated

  float* at(std::size_t pixel) { return values.data() + pixel * static_cast<std::size_t>(channels); }
  const float* at(std::size_t pixel) const { return values.data() + pixel * static_cast<std::size_t>(channels); }
};

/// Returns an image in which all pixels have the background's value and none is covered.
MapImage make_map_image(int size, int channels, glm::dvec4 background);

/// Draws the triangles; `values` are those of the corners. A pixel gets the value at its centre, from the last of the
/// triangles that overlap there; a corner in an uncovered pixel is put into that pixel. Triangles outside [0, 1] are
/// drawn as in a picture that repeats (if they span more than 4 repeats along a side, in the first 4). Deterministic at
/// any thread count.
void draw_triangles(const UvCorners& uvs, std::span<const glm::vec4> values, MapImage& image);

/// Fills pixels within `distance` pixels, [0, 64], of covered ones with the value of the nearest of those, so that
/// bilinear readers see no background at seams.
void dilate(MapImage& image, int distance);

/// Corrects covered pixels around the corners so that a bilinear reader finds exactly its value at each corner
/// (projections onto each corner's equation in turn, Kaczmarz 1937, clamped to [min, max]). Otherwise interpolation
/// would round off extremes at vertices. Corners that share pixels and disagree get a compromise; those in no triangle
/// with an area in the texture are skipped.
void fit_corners(const UvCorners& uvs, std::span<const glm::vec4> values, glm::dvec4 min, glm::dvec4 max,
                 MapImage& image);

/// Counts the triangles with a part outside [0, 1].
std::size_t count_outside(const UvCorners& uvs);

// The content of a map's pixels, and its encoding as numbers in a file.

/// The encoding of a number in a file's channel.
enum class ChannelKind {
  unit,         // unchanged; in 8 and 16 bits [0, 1]
  signed_unit,  // -1 to 1 about the middle: floats (x + 1) / 2; n bits m + (m - 1) x with m = 2^(n-1), so that 0 is
                // exact
  colour,       // linear in floats, sRGB in 8 and 16 bits
  raw,          // floats only
};

/// The channels of a map, and their ranges before it is written.
struct MapLayout {
  int channels = 1;  // [1, 4]
  std::array<ChannelKind, 4> kinds{};
  bool premultiplied = false;  // the first three channels by the fourth, for interpolation
  glm::dvec4 min{0}, max{1};
  glm::dvec4 background{0};  // value where there is no island: the fields' defaults
};

/// Returns the layout of a map. `scale` is in the field's unit, lengths in sizes. The field must fit the encoding,
/// which must not be `automatic`.
MapLayout layout_of(Field field, MapEncoding encoding, double scale, bool floats);

/// Returns the number that encodes a value: for 8 and 16 bits rounded and clamped to the sample's range, for 32 bits
/// the float.
double encode_channel(ChannelKind kind, double value, int bits);
/// The inverse; `number` is a sample divided by its maximum, as in MapPicture.
double decode_channel(ChannelKind kind, double number, int bits);

}  // namespace pelage
