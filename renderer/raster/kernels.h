// The vectorized stages of the rasterizer. They are compiled for several instruction sets (Highway); the best one that
// the machine has is chosen at run time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/raster/raster_scene.h"

namespace pelage {

/// The strands kept of a part, in its order, and the factor on the width of each.
struct KeptStrands {
  std::vector<std::uint32_t> ids;
  std::vector<float> widened;
};

/// Projects the kept strands of a part onto the picture and appends them to `placed`, without their light. Only strands
/// that touch `box` and are not hidden by the skin remain in `kept`. `hidden`: for each block of hiding_side pixels, 1
/// over the distance behind which nothing shows in and around the block.
void place_strands(const RasterScene& scene, const GrownPart& part, const PixelBox& box, std::span<const float> hidden,
                   KeptStrands& kept, PlacedStrands& placed);

/// Bounding box of a strand on the picture, pixels, and what may have changed at its knots (BlockChange).
struct StrandBox {
  float left = 0, top = 0, right = 0, bottom = 0;
  bool fur = false, light = false;
};
/// Writes the box of each kept strand of a part, in order. `blocks` has the BlockChange bits of each block of the grid.
void find_changed(const RasterScene& scene, const GrownPart& part, const KeptStrands& kept,
                  std::span<const std::int32_t> blocks, std::vector<StrandBox>& boxes);

/// Returns how many of a part's first strands are drawn down to their roots, if the strand `last` is the last one kept:
/// one of deep_strand_factor. Roots show only through gaps between strands, so that one wider strand stands for
/// deep_strand_factor of them.
inline std::uint32_t strands_from_root(std::uint32_t last) { return last / deep_strand_factor + 1; }

/// Light that strands send to the camera from some points of each, which are spaced evenly from `from` to the tip.
struct LitPoints {
  static constexpr int max = 16;
  float from = 0;                // position along the strand, [0, 1): 0 is the root
  int count = 2;                 // points of each strand
  bool by_colour = false;        // light is divided by the colour of its point
  std::vector<glm::vec4> light;  // all points of a strand, then those of the next; the fourth number is 0
};
/// Lights the strands `ids` of a part. `from_root`: from the root on; otherwise only their visible upper part
/// (LitKnots).
void light_strands(const RasterScene& scene, const GrownPart& part, std::span<const std::uint32_t> ids, bool from_root,
                   LitPoints& light);

/// Returns the strand whose light a strand takes: a neighbour among the first `own` strands of its part, or the strand
/// itself if that neighbour is more than a sixth shorter and so has no light for the tip.
inline std::uint32_t lit_strand(const StrandSet& set, std::uint32_t id, std::uint32_t own) {
  constexpr float taller = 1.2f;
  std::uint32_t lit = id;
  while (lit >= own) lit = set.neighbour[lit];
  return set.roots[id].reach > taller * set.roots[lit].reach ? id : lit;
}

/// Strands that are placed, and for each the lit strand whose light it takes.
struct LightSources {
  std::span<const std::uint32_t> ids, from;  // numbers in the part: of each strand, and of its lit strand
  std::span<const std::uint32_t> lit;        // index of the lit strand among those of `from_root` and then `upper_part`
  const LitPoints &from_root, &upper_part;   // light of strands drawn from the root on, and of the others
  float own_colour = 1;                      // share of a strand's colour that is its own; the rest is the mean's
};
/// Writes the light of the placed knots of `sources.ids`, which are the strands of `placed` from `first` on: the light
/// of the lit strands' points, multiplied by the colours of the knots if it is by_colour.
void distribute_light(const StrandSet& set, const LightSources& sources, std::size_t first, PlacedStrands& placed);

/// A segment that falls into a tile, by the knots at its two ends.
struct TileSegment {
  const PlacedKnot *from = nullptr, *to = nullptr;
};

/// A tile's transmittance and premultiplied light so far; pixels in the order of pixel_in_tile.
struct TileSums {
  alignas(64) float transmittance[tile_pixels], red[tile_pixels], green[tile_pixels], blue[tile_pixels];
  alignas(64) float background_inverse[tile_pixels];  // 1 / distance of the surface behind the strands, 0 for none
};

/// Returns the index of a tile's pixel in TileSums. Pixels lie in columns of width four, so that registers of 4, 8 and
/// 16 numbers hold blocks of 4 x 1, 4 x 2 and 4 x 4 pixels.
inline constexpr int pixel_in_tile(int x, int y) { return (x >> 2) * (4 * tile_side) + y * 4 + (x & 3); }

/// Blends segments over a tile with the given upper left corner, nearest first, until no light gets through. For
/// RasterOutput::strand, red is the number (from 1) of the segment that covers most of the pixel, green the position
/// along that segment in [0, 1], and blue its coverage.
void blend_segments(const RasterScene& scene, std::span<const TileSegment> segments, int left, int top, TileSums& sums);

/// Intersects the rays of a tile's pixels with the eyes; the upper left corner is given. `background_inverse` has 1 /
/// distance of the skin. Where an eye is nearer, writes the eye's to `background_inverse` and its number to `numbers`.
void intersect_eyes(const RasterScene& scene, int left, int top, std::span<float> background_inverse,
                    std::span<std::int8_t> numbers);
/// Adds the light of the eyes, or what else the scene shows of them, weighted by the transmittance in front of them. At
/// an eye's edge part of the pixel is left to the skin. `background_inverse` and `numbers` are those that
/// intersect_eyes wrote.
void light_eyes(const RasterScene& scene, int left, int top, std::span<const std::int8_t> numbers,
                std::span<const float> background_inverse, TileSums& sums);

/// Pixels that show skin, and what they show: its light or another output of the scene.
struct SkinSeen {
  static constexpr int count = 16;     // lanes of the widest registers
  float x[count] = {}, y[count] = {};  // position on the picture, pixels
  float inverse[count] = {};           // 1 / distance
  std::uint32_t triangle[count] = {};  // triangle of the model
  float red[count] = {}, green[count] = {}, blue[count] = {};
};
void light_skin(const RasterScene& scene, SkinSeen& seen);

/// Darkens the pixels of a tile that show the ground, once all in front of it is drawn. The ground's shadow is black
/// with an alpha: it lowers the transmittances in `transmittance`, which lie in the order of pixel_in_tile.
void darken_ground(const RasterScene& scene, int left, int top, std::span<float> transmittance);

/// Adds the strands and the body of each cell, times `share`, to `sums`, which has two numbers for each cell.
void add_cells(std::span<const Crossed> cells, float share, float* sums);
/// Rounds such sums and stores them in `cells`: to whole steps, or with `quantize` to coarser steps that are too small
/// to be seen, with one value for all cells that no light reaches. Returns a range that contains all cells that
/// changed.
CellRange round_cells(const float* sums, bool quantize, std::span<Crossed> cells);

/// The instruction set in use, as "AVX2".
const char* instruction_set();

}  // namespace pelage
