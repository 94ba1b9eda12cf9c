// Pictures in linear light: what is measured, what lights a scene, and what a farm keeps.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "renderer/image/image.h"

namespace pelage {

/// Linear light with sRGB's primaries, multiplied by alpha, rows from the top, 4 * width * height numbers. Any float
/// may be in it: what reads one decides what it does with NaN and infinity.
struct FloatImage {
  int width = 0, height = 0;
  std::vector<float> rgba;
  bool display_referred = false;  // from PNG or JPEG: tone mapped and held to [0, 1] already
};

FloatImage linear_image(const Image& image);

/// Of numbers that are sRGB with straight alpha, in place.
void make_linear_and_premultiplied(FloatImage& image);

/// A picture whose numbers are data: no curve is undone and nothing is multiplied by alpha. 8 and 16 bits are over
/// their largest, 4 * width * height numbers, rows from the top.
struct DataImage {
  int width = 0, height = 0;
  int bits = 8;  // 8, 16, or 32 for any float
  std::vector<float> rgba;
  std::string text;  // what the file keeps under the asked key; "" for nothing
};

/// Under which a map's file says what 1 in it stands for.
inline constexpr const char* map_scale_text = "pelage:scale";

/// Under which an EXR has its frames per second; the text is a ratio, "24/1".
inline constexpr const char* frame_rate_text = "FramesPerSecond";
/// Under which an EXR has the colour space of its colours, unless that is linear Rec. 709, and how the keys begin that
/// say what its cryptomatte is of.
inline constexpr const char *colour_space_text = "pelage/colourSpace", *matte_text = "cryptomatte/";

enum class ExrSample { half, single };

/// One channel of an EXR: the value of pixel i, rows from the top, is values[offset + i * stride].
struct ExrPlane {
  std::string channel;  // "R", "A", "Z", "normal.X"; unique in a file
  std::span<const float> values;
  std::size_t offset = 0, stride = 1;
  ExrSample sample = ExrSample::half;
};

/// R, G, B and A of interleaved RGBA; with an AOV's name their names are "AOV.R" and so on.
std::vector<ExrPlane> rgba_planes(std::span<const float> rgba, ExrSample sample, const std::string& aov = {});

/// The camera of an EXR's whole picture, as OpenEXR's standard attributes of these names have it: for row vectors, row
/// after row. Camera space is left-handed, looks along +Z and has Y up; in NDC the whole is [0, 1] to the right and
/// down.
struct ExrCamera {
  std::array<float, 16> world_to_camera{}, world_to_ndc{};
};

/// The pixels of an EXR (its data window), and the whole that they are a part of (its display window): 0 for no more
/// than they.
struct ExrWindow {
  int width = 0, height = 0, left = 0, top = 0;
  int full_width = 0, full_height = 0;
  std::optional<ExrCamera> camera = {};
};

}  // namespace pelage
