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

/// Rows from the top, v up: pixel (x, y) has its centre at u = (x + .5) / size, v = 1 - (y + .5) / size.
struct MapImage {
  int size = 1;                       // pixels of a side, [1, 8192]
  int channels = 1;                   // [1, 4]
  std::vector<float> values;          // channels * size * size
  std::vector<std::uint8_t> covered;  // size * size: 1 where `values` holds something of the model

  float* at(std::size_t pixel) { return values.data() + pixel * static_cast<std::size_t>(channels); }
  const float* at(std::size_t pixel) const { return values.data() + pixel * static_cast<std::size_t>(channels); }
};

/// All pixels hold the background and none is covered.
MapImage make_map_image(int size, int channels, glm::dvec4 background);

/// Draws the triangles; `values` are those of the corners. A pixel takes what lies under its centre, of triangles that
/// overlap that of the last one; a corner that no pixel's centre shows is put into the pixel that it lies in. What lies
/// outside [0, 1] is drawn where a picture that repeats shows it (of a triangle that spans more than 4 repeats along a
/// side, the first 4). The same at any thread count.
void draw_triangles(const UvCorners& uvs, std::span<const glm::vec4> values, MapImage& image);

/// Gives pixels within `distance` pixels of covered ones, [0, 64], what the nearest of those holds, so that readers
/// that mix pixels see no background at seams.
void dilate(MapImage& image, int distance);

/// Corrects covered pixels around the corners so that a bilinear reader finds at each corner just its value
/// (projections onto each corner's equation in turn, Kaczmarz 1937, held in [least, most]). Without it mixing rounds
/// off what bends at a vertex. Corners that share pixels and disagree find a compromise; those in
/// no triangle with an area in the texture are left alone.
void fit_corners(const UvCorners& uvs, std::span<const glm::vec4> values, glm::dvec4 min, glm::dvec4 max,
                 MapImage& image);

/// Triangles with a part outside [0, 1].
std::size_t count_outside(const UvCorners& uvs);

// What the pixels of a map hold, and the numbers that stand for it in a file.

/// How a file's channel holds a number.
enum class ChannelKind {
  share,     // as it is; in 8 and 16 bits 0 to 1
  part,      // -1 to 1 about the middle: floats (x + 1) / 2; n bits m + (m - 1) x with m = 2^(n-1), so that 0 is exact
  colour,    // linear in floats, sRGB in 8 and 16 bits
  as_it_is,  // floats only
};

/// Channels of a map, and what they may hold before it is written.
struct MapLayout {
  int channels = 1;  // [1, 4]
  std::array<ChannelKind, 4> kinds{};
  bool premultiplied = false;  // the first three by the fourth, while pixels are mixed
  glm::dvec4 min{0}, max{1};
  glm::dvec4 background{0};  // where no island reaches: the fields at rest
};

/// `scale` is in the field's unit, lengths in sizes. The field fits the encoding, which is not `automatic`.
MapLayout layout_of(Field field, MapEncoding encoding, double scale, bool floats);

/// The number of a sample of 8 or 16 bits, rounded and held at its ends; of 32 bits the float itself.
double file_number(ChannelKind kind, double value, int bits);
/// And back; `number` is a sample over its largest, as in MapPicture.
double value_of(ChannelKind kind, double number, int bits);

}  // namespace pelage
