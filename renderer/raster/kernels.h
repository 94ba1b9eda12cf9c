// What is compiled for several instruction sets, of which the machine's best is chosen when the program runs.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/raster/raster_scene.h"

namespace pelage {

/// Strands that are kept of a part, in its order, and by how much each is widened.
struct KeptStrands {
  std::vector<std::uint32_t> ids;
  std::vector<float> widened;
};

inline constexpr int hiding_side = 4;                  // pixels of the blocks by which skin hides strands
inline constexpr int hidden_around = 2 * hiding_side;  // pixels about a block that its number holds for

/// Places strands of a part, without their light, and leaves those in `kept` that touch `box` and are not hidden by the
/// skin: `hidden` has one over the distance behind which nothing shows in and around each block of hiding_side pixels.
void place_strands(const RasterScene& scene, const GrownPart& part, const PixelBox& box, std::span<const float> hidden,
                   KeptStrands& kept, PlacedStrands& placed);

/// Where nothing but gaps between strands shows them, some strands stand for all: the first ones, which are drawn down
/// to their roots. Their number, where the last that is kept is `last`.
inline constexpr std::uint32_t deep_of = 8;  // strands that one stands for
inline std::uint32_t whole_strands(std::uint32_t last) { return last / deep_of + 1; }

/// Light that a strand sends to the camera, or what else is shown of it, from some points of it, evenly from `from` in
/// [0, 1) to the tip.
struct LitStrandPoints {
  static constexpr int max = 16;
  float from = 0;
  int count = 2;
  std::array<glm::vec4, max> light{};  // the fourth is 0
};
/// With `whole` from the root on, else from where they come to be seen.
void light_strands(const RasterScene& scene, const GrownPart& part, std::span<const std::uint32_t> ids, bool whole,
                   std::span<LitStrandPoints> light);

/// Writes the light of a strand's knots, which lie `along` it: `light` is that of strand `from`, which may be another.
void hand_on_light(const StrandSet& set, std::uint32_t id, std::uint32_t from, const LitStrandPoints& light,
                   std::span<const float> along, std::span<PlacedKnot> knots);

/// What of a strand falls into a tile.
struct TileSegment {
  const PlacedKnot *from = nullptr, *to = nullptr;
};

/// A tile's light and what gets through to what lies behind its strands, pixels in blocks (pixel_in_tile).
struct TileSums {
  alignas(64) float through[tile_pixels], red[tile_pixels], green[tile_pixels], blue[tile_pixels];
  alignas(64) float behind[tile_pixels];  // one over the distance of what ends the strands' view
};

/// Where a tile's pixel lies in its sums: in columns of four, so that registers of 4, 8 and 16 numbers hold blocks of
/// 4 x 1, 4 x 2 and 4 x 4 pixels.
inline constexpr int pixel_in_tile(int x, int y) { return (x >> 2) * (4 * tile_side) + y * 4 + (x & 3); }

/// Blends segments over a tile whose left upper corner is given, nearest first, until nothing gets through.
void blend_segments(const RasterScene& scene, std::span<const TileSegment> segments, int left, int top, TileSums& sums);

/// What shows less of a pixel than this shows nothing.
inline constexpr float min_shown = 1e-3f;

/// Eyes in a tile whose left upper corner is given. `ends` has one over the distance of what ends the view of strands:
/// that of an eye where it is nearest, whose number goes to `numbers`.
void meet_eyes(const RasterScene& scene, int left, int top, std::span<float> ends, std::span<std::int8_t> numbers);
/// Adds their light, or what else is shown, by what gets through to them; the skin beside an eye's edge still gets the
/// rest. `ends` as meet_eyes left it.
void light_eyes(const RasterScene& scene, int left, int top, std::span<const std::int8_t> numbers,
                std::span<const float> ends, TileSums& sums);

/// Some pixels that show skin, and its light there, or what else is shown.
struct SkinSeen {
  static constexpr int count = 16;     // as many as the widest registers hold
  float x[count] = {}, y[count] = {};  // pixels of the picture
  float inverse[count] = {};           // one over the distance
  std::uint32_t piece[count] = {};     // triangle of the model
  float red[count] = {}, green[count] = {}, blue[count] = {};
};
void light_skin(const RasterScene& scene, SkinSeen& seen);

/// Darkens what shows the scene's ground of a tile, after all that stands before it: it is black with an alpha.
void darken_ground(const RasterScene& scene, int left, int top, TileSums& sums);

/// The instruction set in use, as "AVX2".
const char* raster_instruction_set();

}  // namespace pelage
