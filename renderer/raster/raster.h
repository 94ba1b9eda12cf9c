// The rasterizer of strands on the CPU. It draws the same strands as the path tracer: culls and thins them, lights
// some, sorts their segments by tile and distance, and blends them front to back over skin and eyes.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "renderer/image/float_image.h"
#include "renderer/raster/raster_scene.h"
#include "renderer/strands/grown_fur.h"

namespace pelage {

/// Counts of a drawing, summed over its boxes.
struct RasterCounts {
  std::size_t strands = 0;  // strands of all coats, and curves
  std::size_t placed = 0;   // strands that touch a box and are not culled
  std::size_t lit = 0;      // lit strands; on a GPU, lit points
  std::size_t entries = 0;  // segments, counted once in each tile that they touch
  std::size_t bytes = 0;    // memory of the largest box, without the coat
};

/// Scratch memory for placed strands, reused from box to box.
class RasterScratch {
 public:
  RasterScratch();
  ~RasterScratch();

 private:
  friend class Raster;
  struct Buffers;
  std::unique_ptr<Buffers> buffers_;
};

/// Belongs to one thread; draws on up to `threads` threads, with the same bits for any number.
class Raster {
 public:
  /// Several rasterizers on one thread may share `scratch`.
  explicit Raster(int threads, std::shared_ptr<RasterScratch> scratch = std::make_shared<RasterScratch>());
  ~Raster();

  /// Draws premultiplied linear light of the skin and its strands, or `output`. Alpha is their coverage, and
  /// for light also the ground's darkening. With a crop the picture still has the frame's size; inside the crop it has
  /// the same bits as the whole frame.
  FloatImage draw(const FurModel& model, const GrownFur& fur, const FurFrame& frame, const RasterQuality& quality,
                  RasterCounts* counts = nullptr, RasterOutput output = RasterOutput::light);

  /// Returns the bytes of memory that are kept from picture to picture.
  std::size_t bytes() const;

  /// Returns the version of what was drawn (DensityGrid::version), for changed_since.
  std::uint64_t version() const;

  /// Returns boxes of whole tiles that cover a frame, row by row, of at most about `pixels` pixels each. They let a
  /// caller draw the same picture in steps and do other things in between.
  static std::vector<PixelBox> boxes_of(const FurFrame& frame, int pixels = 1 << 20);
  /// Returns what a frame is drawn from, with views of the arguments and of this object; valid until the next call.
  RasterScene scene_of(const FurModel& model, const GrownFur& fur, const FurFrame& frame, const RasterQuality& quality,
                       RasterOutput output);
  /// Computes the shadows of a scene: the density grid, the near cells and the sky over the ground. Call it before
  /// drawing the scene with this object.
  void fill_cells(RasterScene& scene);
  /// Returns a scene of the skin and the eyes alone, in unshadowed light. `skin`: the look of the three corners of each
  /// triangle of the model.
  RasterScene bare_scene_of(const FurModel& model, std::span<const std::array<SkinLook, 3>> skin, const FurFrame& frame,
                            RasterOutput output);
  /// Draws a box into a picture of the frame's size, without the ground.
  void draw_box(const RasterScene& scene, const PixelBox& box, FloatImage& picture, RasterCounts& counts) const;
  /// Darkens the pixels of a drawn box that show the ground.
  void darken_box(const RasterScene& scene, const PixelBox& box, FloatImage& picture) const;

 private:
  struct Cache;  // what is cached from frame to frame
  int threads_;
  std::shared_ptr<RasterScratch> scratch_;
  std::unique_ptr<Cache> cache_;
};

}  // namespace pelage
