// Pictures in linear light, pictures of data, and the channels of an EXR.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "renderer/image/image.h"

namespace pelage {

/// Linear light with sRGB primaries, premultiplied by alpha, rows from the top, 4 * width * height numbers. Any float
/// is allowed; readers decide how to treat NaN and infinity.
struct FloatImage {
  int width = 0, height = 0;
  std::vector<float> rgba;
  bool display_referred = false;  // from PNG or JPEG: already tone mapped and clamped to [0, 1]
};

FloatImage linear_image(const Image& image);

/// Converts sRGB with straight alpha in place.
void make_linear_and_premultiplied(FloatImage& image);

/// A picture whose numbers are data: no transfer curve is undone and nothing is multiplied by alpha. Numbers of 8 and
/// 16 bits are divided by their largest value. 4 * width * height numbers, rows from the top.
struct DataImage {
  int width = 0, height = 0;
  int bits = 8;  // 8, 16, or 32 for any float
  std::vector<float> rgba;
  std::string text;  // text stored in the file under the requested key; "" for none
};

/// The key of the text in a map's file that says what 1 stands for.
inline constexpr const char* map_scale_text = "pelage:scale";

/// The key of an EXR's frames per second; the text is a ratio, "24/1".
inline constexpr const char* frame_rate_text = "FramesPerSecond";
/// The key of an EXR's colour space, unless that is linear Rec. 709, and the prefix of the keys that describe its
/// cryptomatte.
inline constexpr const char *colour_space_text = "pelage/colourSpace", *matte_text = "cryptomatte/";

enum class ExrSample { half, single };

/// One channel of an EXR: the value of pixel i, rows from the top, is values[offset + i * stride].
struct ExrPlane {
  std::string channel;  // "R", "A", "Z", "normal.X"; unique in a file
  std::span<const float> values;
  std::size_t offset = 0, stride = 1;
  ExrSample sample = ExrSample::half;
};

/// Returns the R, G, B and A planes of interleaved RGBA; with an AOV's name the channels are "AOV.R" and so on.
std::vector<ExrPlane> rgba_planes(std::span<const float> rgba, ExrSample sample, const std::string& aov = {});

/// The camera of an EXR's whole picture, as in OpenEXR's standard attributes of these names: for row vectors, row by
/// row. Camera space is left-handed, looks along +Z and has Y up; in NDC the whole picture is [0, 1] to the right and
/// down.
struct ExrCamera {
  std::array<float, 16> world_to_camera{}, world_to_ndc{};
};

/// The pixels of an EXR (its data window), and the whole picture that they are a part of (its display window); 0 if
/// they are the whole.
struct ExrWindow {
  int width = 0, height = 0, left = 0, top = 0;
  int full_width = 0, full_height = 0;
  std::optional<ExrCamera> camera = {};
};

}  // namespace pelage
