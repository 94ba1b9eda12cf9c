// What the pixels of a map hold, and the numbers that stand for it in a file.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "protocol/commands/map.h"

namespace pelage {

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
  glm::dvec4 least{0}, most{1};
  glm::dvec4 background{0};    // where no island reaches: the fields at rest
};

/// `scale` is in the field's unit, lengths in sizes. The field fits the encoding, which is not `automatic`.
MapLayout layout_of(Field field, MapEncoding encoding, double scale, bool floats);

/// The number of a sample of 8 or 16 bits, rounded and held at its ends; of 32 bits the float itself.
double file_number(ChannelKind kind, double value, int bits);
/// And back; `number` is a sample over its largest, as in MapPicture.
double value_of(ChannelKind kind, double number, int bits);

}  // namespace pelage
