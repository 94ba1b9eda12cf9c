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

/// Places strands of a part, without their light, and leaves those in `kept` whose box touches `box` nearer than what
/// lies behind it: `furthest` has one over the distance for each tile of the box.
void place_strands(const RasterScene& scene, const StrandSet& set, const RasterBox& box, std::span<const float> furthest,
                   KeptStrands& kept, PlacedStrands& placed);

/// Points of a strand of so many segments that are lit, root and tip among them.
int lit_points(int segments);

/// Light that strands of a set send to the camera, lit_points times three numbers each.
void light_strands(const RasterScene& scene, const StrandSet& set, std::span<const std::uint32_t> ids,
                   std::vector<float>& light);

/// Writes the light of a strand's knots: `light` is that of the points of strand `from`, which may be another.
void hand_on_light(const StrandSet& set, std::uint32_t id, std::uint32_t from, const float* light,
                   std::span<PlacedKnot> knots);

/// What of a strand falls into a tile.
struct TileSegment {
  const PlacedKnot *from = nullptr, *to = nullptr;
};

/// A tile's light and what gets through to what lies behind its strands, pixels in blocks (pixel_in_tile).
struct TileSums {
  alignas(64) float through[tile_pixels], red[tile_pixels], green[tile_pixels], blue[tile_pixels];
  alignas(64) float behind[tile_pixels];  // one over the distance of what ends the strands' view
};

/// Where a tile's pixel lies in its sums: in blocks of 4 x 2, which a register holds.
inline int pixel_in_tile(int x, int y) { return ((y >> 1) * (tile_side / 4) + (x >> 2)) * 8 + (y & 1) * 4 + (x & 3); }

/// Blends segments over a tile whose left upper corner is given, nearest first, until nothing gets through.
void blend_segments(std::span<const TileSegment> segments, int left, int top, float min_width, TileSums& sums);

/// Up to eight pixels that show skin, and its light there.
struct SkinSeen {
  static constexpr int count = 8;
  float x[count] = {}, y[count] = {};  // pixels of the picture
  float inverse[count] = {};           // one over the distance
  std::uint32_t piece[count] = {};     // triangle of the model
  float red[count] = {}, green[count] = {}, blue[count] = {};
};
void light_skin(const RasterScene& scene, SkinSeen& seen);

/// The instruction set in use, as "AVX2".
const char* raster_instruction_set();

}  // namespace pelage
