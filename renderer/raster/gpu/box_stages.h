// Runs the GPU stages that draw a box, one after the other, and owns the buffers between them.
#pragma once

#include <cstdint>
#include <span>

#include "renderer/finish/encode.h"
#include "renderer/image/float_image.h"
#include "renderer/image/image.h"
#include "renderer/raster/gpu/scene_data.h"
#include "renderer/raster/gpu/stages.h"

namespace pelage {

/// What the stages of a box produced, counted even where the buffers had no room for it.
struct Totals {
  std::uint32_t knots = 0, lit_points = 0, entries = 0, unused = 0;  // entries: segments by tile
};

class BoxStages {
 public:
  /// No buffer gets larger than `max_bytes`, nor than the GL allows.
  BoxStages(const Gl& gl, std::size_t max_bytes);

  /// Runs all stages of a box on the GPU, from the grid's cells to the finished rows of pixels. Returns false if a
  /// stage cannot be built: stages().failure() says why.
  bool draw(const DrawnBox& box, SceneData& data);
  /// Returns what the last draw produced; waits for it. What exceeds the available room is missing from the picture.
  Totals totals() const;
  /// Returns whether buffers may grow to hold all of it.
  bool has_room_for(const Totals& found) const;
  /// Makes the next draw reserve room for all of it. Returns false if there was room already.
  bool grow_capacities(const Totals& found);
  /// Reads the rows of a box into the picture, but only the tiles that are drawn.
  void read(const RasterScene& scene, const PixelBox& box, FloatImage& picture) const;
  /// Encodes the rows, which have to be the whole picture of the scene. Returns false as `draw` does.
  bool encode(const RasterScene& scene, const Encoding& encoding);
  /// Reads the encoded rows into a picture of their size.
  void read(Image& picture) const { encoded_.read(0, std::span(picture.rgba)); }

  /// Frees all buffers and resets their sizes to those at the start.
  void release();
  std::size_t max_bytes() const { return max_bytes_; }
  Stages& stages() { return stages_; }

 private:
  void reserve(const DrawnBox& box);
  bool begin(Stage stage, const DrawnBox& box, std::initializer_list<StageStorage> storage);
  bool begin_eyes(Stage stage, const DrawnBox& box, const SceneData& data, const Storage& pixels);
  /// Replaces each number by the sum of all numbers before it (exclusive prefix sum).
  bool scan(const DrawnBox& box, const Storage& numbers, std::size_t count);
  /// Rasterizes skin and eyes, and finds behind which distance nothing is visible.
  bool find_skin(const DrawnBox& box, const SceneData& data);
  /// Counts the knots that each strand is drawn with, then writes them.
  bool place_strands(const DrawnBox& box, const SceneData& data);
  /// Lights the strands whose light a drawn strand takes, and derives the light of all drawn knots.
  bool light_strands(const DrawnBox& box, const SceneData& data);
  /// Counts the segments of each tile, then writes and sorts them.
  bool fill_tiles(const DrawnBox& box);
  /// Blends the strands, calls add_behind, and writes the result to rows of pixels.
  bool blend(const DrawnBox& box, const SceneData& data);
  /// Adds eyes and skin behind the strands, then darkens the ground.
  bool add_behind(const DrawnBox& box, const SceneData& data);

  const Gl& gl_;
  std::size_t max_bytes_;
  Stages stages_;
  const Program* current_ = nullptr;  // of the stage that begin() made current
  StageCapacities capacities_;
  Storage skin_pixels_, eye_pixels_, ends_, furthest_, blocks_, hidden_;  // for each pixel, tile or block of pixels
  Storage strand_knots_, strand_points_, knots_, lit_points_;
  Storage tile_entries_, tile_counts_, entries_, others_;
  Storage sums_, scan_sums_, rows_, encoded_;
};

}  // namespace pelage
