// The stages of a box one after the other, and what they hand on.
#pragma once

#include <cstdint>
#include <span>

#include "renderer/finish/encode.h"
#include "renderer/image/float_image.h"
#include "renderer/image/image.h"
#include "renderer/raster/gpu/scene_data.h"
#include "renderer/raster/gpu/stages.h"

namespace pelage {

/// What the stages of a box found, and how much of it there was room for.
struct Totals {
  std::uint32_t knots = 0, lit_points = 0, entries = 0, unused = 0;
};

class BoxStages {
 public:
  /// No buffer gets larger than `max_bytes`, nor than the GL allows.
  BoxStages(const Gl& gl, std::size_t max_bytes);

  /// Runs all stages of a box on the GPU, from finding its cells to blending its rows of pixels. Returns false if a
  /// stage cannot be built: failure() says why.
  bool draw(const DrawnBox& box, SceneData& data);
  /// Returns what the last draw found; waits for it. What exceeds the available room is missing from the picture.
  Totals totals() const;
  /// Returns whether buffers can be as large as that.
  bool has_room_for(const Totals& found) const;
  /// Makes room for what was found; false where there was enough.
  bool take_more_room(const Totals& found);
  /// Reads the rows of a box into the picture, only for tiles that are drawn.
  void read(const RasterScene& scene, const PixelBox& box, FloatImage& picture) const;
  /// Encodes the rows, which are the whole of the scene's picture. Returns false as `draw` does.
  bool encode(const RasterScene& scene, const Encoding& encoding);
  /// Reads the encoded rows into a picture of their size.
  void read(Image& picture) const { encoded_.read(0, std::span(picture.rgba)); }

  /// Drops all buffers, and what they had room for.
  void give_back();
  std::size_t max_bytes() const { return max_bytes_; }
  Stages& stages() { return stages_; }

 private:
  void reserve(const DrawnBox& box);
  bool begin(Stage stage, const DrawnBox& box, std::initializer_list<StageStorage> storage);
  bool begin_eyes(Stage stage, const DrawnBox& box, const SceneData& data, const Storage& pixels);
  /// Replaces each number by the sum of those before it.
  bool scan(const DrawnBox& box, const Storage& numbers, std::size_t count);
  bool find_skin(const DrawnBox& box, const SceneData& data);
  /// Counts the knots of each strand, and writes them.
  bool place_strands(const DrawnBox& box, const SceneData& data);
  /// Lights the strands whose light is asked for, and hands it on.
  bool light_strands(const DrawnBox& box, const SceneData& data);
  /// Counts the segments of each tile, writes and sorts them.
  bool fill_tiles(const DrawnBox& box);
  /// Blends the strands, adds what is behind them, then darkens the ground, and writes the result to rows of pixels.
  bool blend(const DrawnBox& box, const SceneData& data);
  bool add_behind(const DrawnBox& box, const SceneData& data);

  const Gl& gl_;
  std::size_t max_bytes_;
  Stages stages_;
  const Program* current_ = nullptr;  // that was begun
  StageRooms rooms_;
  Storage skin_pixels_, eye_pixels_, ends_, furthest_, blocks_, hidden_;  // of pixels, tiles and blocks of pixels
  Storage strand_knots_, strand_points_, knots_, lit_points_;
  Storage tile_entries_, tile_counts_, entries_, others_;
  Storage sums_, scan_sums_, rows_, encoded_;
};

}  // namespace pelage
