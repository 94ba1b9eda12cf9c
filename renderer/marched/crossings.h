// What the rays of a tile's pixels meet: crossings of shells by depth, and the segments of fur between them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/marched/march_scene.h"

namespace pelage {

/// One triangle of a shell over one group of pixels.
struct Record {
  std::uint32_t piece = 0, patch = 0;
  float height = 0;        // of the shell, [0, 1]
  float dense = 1;         // strands here over those on the tile
  bool facing = true;      // seen from outside
  bool outermost = false;  // no fur lies beyond the shell
  std::uint32_t lanes = 0;
  std::uint32_t next = 0;  // of the same group, counted from 1; 0 for the last
};

struct Crossing {
  float inverse = 0;  // 1 / distance along the view
  std::uint32_t record = 0;
  glm::vec2 tile{0};  // place on it, tiles
};

/// Fur of one patch between two crossings of a ray.
struct Segment {
  std::uint32_t near = 0, far = 0;  // records
};

/// The nearest skin of each pixel of a tile, in the order of groups and lanes.
struct SkinPixels {
  static constexpr std::size_t pixels = Tile::side * Tile::side;
  std::array<float, pixels> inverse{}, second{}, third{};  // shares of the second and third corner on the picture
  std::array<std::int32_t, pixels> piece{};                // ~piece where it is seen from inside
  std::array<std::uint32_t, pixels> cut{};                 // ShellTriangle::cut
};

/// The eyes that a tile shows, in the order of SkinPixels.
struct EyePixels {
  bool there = false;                                    // whether any may be; the rest is not read otherwise
  std::array<float, SkinPixels::pixels> inverse{};       // of what is nearest, eye or skin
  std::array<std::int8_t, SkinPixels::pixels> number{};  // of the eye, -1 for none

  /// Lays the skin down once a tile.
  void begin(const SkinPixels& skin);
};

/// Lit pixels of guided curves, before all skin and eyes.
struct CurvePixels {
  struct Pixel {
    int number = 0;          // in the order of SkinPixels
    float inverse = 0;       // 1 / distance along the view
    glm::vec4 light{0};      // premultiplied
    std::uint32_t aovs = 0;  // place in CurvePixels::aovs
  };
  std::vector<Pixel> pixels;
  std::vector<AovPixel> aovs;                                 // multiplied by nothing; empty where none are asked for
  std::array<std::uint32_t, SkinPixels::pixels + 1> first{};  // of each of the tile's pixels, and one more

  /// By pixel, from near to far, and what lies at the same place as it came.
  void sort();
};

/// What one thread needs to draw tiles, used again for each.
struct TileScratch {
  SkinPixels skin;
  EyePixels eyes;
  CurvePixels curves;  // not read where the scene has none
  std::vector<Record> records;
  std::vector<float> values;                                      // of all records, row by row
  std::array<std::uint32_t, SkinPixels::pixels> first{}, last{};  // record of each group, counted from 1
  std::array<std::vector<Crossing>, 16> crossings;                // of each lane
  std::array<std::vector<Segment>, 16> segments;

  void clear();
  /// Depths that fur ends at.
  const float* nearest() const { return eyes.there ? eyes.inverse.data() : skin.inverse.data(); }
  /// Room for the numbers of a record, valid until the next one is added.
  float* add(const Record& record, int group, int numbers);
};

/// From near to far; crossings of the same depth stay in their order.
void sort_by_depth(std::vector<Crossing>& crossings);

/// The segments between sorted crossings, by the depth of their far ends. A ray may go through several folds of a body
/// at once: each crossing goes with the one of its patch before it that is nearest on the tile, where the ray may have
/// stayed in the fur between. `reach`: no further, tiles.
void find_segments(std::span<const Crossing> crossings, std::span<const Record> records, float reach,
                   std::vector<Segment>& segments);

}  // namespace pelage
