// Strands drawn by a rasterizer on the CPU: the strands that are traced, culled, thinned, lit, sorted and blended.
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

/// What a picture was drawn from.
struct RasterCounts {
  std::size_t strands = 0;  // that stand in the coat
  std::size_t placed = 0;   // that touch the picture
  std::size_t lit = 0;
  std::size_t entries = 0;  // segments by tile
  std::size_t bytes = 0;    // of the largest box, beside the coat
};

/// Memory for strands on their way to the picture, which is used again from box to box.
class RasterRoom {
 public:
  RasterRoom();
  ~RasterRoom();

 private:
  friend class Raster;
  struct Held;
  std::unique_ptr<Held> held_;
};

/// Belongs to one thread; draws on up to `threads`, with the same bits for any number of them.
class Raster {
 public:
  /// Several on one thread may share a room.
  explicit Raster(int threads, std::shared_ptr<RasterRoom> room = std::make_shared<RasterRoom>());
  ~Raster();

  /// Premultiplied linear light of the skin and its strands, or what else is shown: alpha is what they cover, and of
  /// light also what the ground darkens. Of a frame with a crop the picture has the frame's size, and the bits that the
  /// whole frame has where the crop is.
  FloatImage draw(const FurModel& model, const GrownFur& fur, const FurFrame& frame, const RasterQuality& quality,
                  RasterCounts* counts = nullptr, RasterOutput shown = RasterOutput::light);

  /// That it keeps from picture to picture.
  std::size_t bytes() const;

  /// Of what was drawn, for changed_since.
  std::uint64_t version() const;

  /// Returns boxes of whole tiles that cover a frame, row by row, of at most about `pixels` pixels each. They let a
  /// caller draw the same picture in steps and do other things in between.
  static std::vector<PixelBox> boxes_of(const FurFrame& frame, int pixels = 1 << 20);
  /// What a frame is drawn from; views of all that is given and of this object, until the next call.
  RasterScene scene_of(const FurModel& model, const GrownFur& fur, const FurFrame& frame, const RasterQuality& quality,
                       RasterOutput shown);
  /// Finds what stands in the way of a scene's light. Call it before drawing the scene with this object.
  void fill_cells(RasterScene& scene);
  /// The scene of the skin and the eyes alone, in unshadowed light; `skin` has the look of each piece's corners.
  RasterScene bare_scene_of(const FurModel& model, std::span<const std::array<SkinLook, 3>> skin, const FurFrame& frame,
                            RasterOutput shown);
  /// Into a picture of the frame's size, without the ground.
  void draw_box(const RasterScene& scene, const PixelBox& box, FloatImage& picture, RasterCounts& counts) const;
  /// Darkens what shows the ground in such a box.
  void darken_box(const RasterScene& scene, const PixelBox& box, FloatImage& picture) const;

 private:
  struct Kept;  // from frame to frame
  int threads_;
  std::shared_ptr<RasterRoom> room_;
  std::unique_ptr<Kept> kept_;
};

}  // namespace pelage
