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

/// Places strands of a part, without their light, and leaves those in `kept` that touch `box` and are not hidden by the
/// skin: `hidden` has one over the distance behind which nothing shows in and around each block of hiding_side pixels.
void place_strands(const RasterScene& scene, const GrownPart& part, const PixelBox& box, std::span<const float> hidden,
                   KeptStrands& kept, PlacedStrands& placed);

/// What a strand covers of the picture, pixels, and what may be another at its knots.
struct StrandBox {
  float left = 0, top = 0, right = 0, bottom = 0;
  bool fur = false, light = false;
};
/// Of the kept strands of a part, one after the other. `blocks` has bits of BlockChange for each block of the grid.
void find_changed(const RasterScene& scene, const GrownPart& part, const KeptStrands& kept,
                  std::span<const std::int32_t> blocks, std::vector<StrandBox>& boxes);

/// Where nothing but gaps between strands shows them, one stands for deep_of: the first ones, which are drawn down to
/// their roots. Their number, where the last that is kept is `last`.
inline std::uint32_t whole_strands(std::uint32_t last) { return last / deep_of + 1; }

/// What strands send to the camera, from some points of each, evenly from `from` in [0, 1) to the tip.
struct LitPoints {
  static constexpr int max = 16;
  float from = 0;
  int count = 2;                 // of each strand
  bool by_colour = false;        // over the colours of the points
  std::vector<glm::vec4> light;  // point by point, strand by strand; the fourth is 0
};
/// With `whole` from the root on, else from where they come to be seen.
void light_strands(const RasterScene& scene, const GrownPart& part, std::span<const std::uint32_t> ids, bool whole,
                   LitPoints& light);

/// Returns the strand whose light a strand takes: one of the first `own` of its part, or the strand itself where that
/// one is shorter by a sixth, and so has no light for the tip.
inline std::uint32_t lit_strand(const StrandSet& set, std::uint32_t id, std::uint32_t own) {
  constexpr float taller = 1.2f;
  std::uint32_t lit = id;
  while (lit >= own) lit = set.neighbour[lit];
  return set.roots[id].reach > taller * set.roots[lit].reach ? id : lit;
}

/// Strands that are placed, and of each the lit one whose light it has.
struct LightSources {
  std::span<const std::uint32_t> ids, from;  // own numbers in the part: of each, and of the lit one
  std::span<const std::uint32_t> lit;        // the place of that in these:
  const LitPoints &whole, &rest;             // first those that are drawn from the root on, then the others
  float own_colour = 1;                      // share of a strand's colour that is its own; the rest is the mean's
};
/// Writes the light of their knots, by their colours: they are the strands of `placed` from `first` on.
void hand_on_light(const StrandSet& set, const LightSources& sources, std::size_t first, PlacedStrands& placed);

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

/// Blends segments over a tile whose left upper corner is given, nearest first, until nothing gets through. Where
/// strands are shown red is the segment that covers most, from 1 on, green where on it, and blue how much it covers.
void blend_segments(const RasterScene& scene, std::span<const TileSegment> segments, int left, int top, TileSums& sums);

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
/// `through` has what of each pixel is open, in blocks.
void darken_ground(const RasterScene& scene, int left, int top, std::span<float> through);

/// Adds the strands and the body of cells, times `share`, to sums that lie in the same order.
void add_cells(std::span<const Crossed> cells, float share, float* sums);
/// Rounds such sums to cells: in the finest steps, or `as_seen`, in steps that are not seen, with all cells alike that
/// no light gets to. Gives a range that has all cells which change, with few that do not.
CellRange round_cells(const float* sums, bool as_seen, std::span<Crossed> cells);

/// The instruction set in use, as "AVX2".
const char* instruction_set();

}  // namespace pelage
