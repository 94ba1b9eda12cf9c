// Pictures of the model without its strands: the shape of the model, and the backplate of traced strands.
#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <vector>

#include "base/parallel.h"
#include "renderer/frame/raster_fur.h"
#include "renderer/frame/raster_renderer.h"
#include "renderer/overlay/field_picture.h"
#include "renderer/raster/raster.h"
#include "renderer/strands/grow.h"

namespace pelage {

namespace {

/// Returns the look of the skin between the strands at the corners of each triangle of the model.
std::vector<std::array<SkinLook, 3>> skin_of(const RasterModel& own, const FurFrame& frame, int threads) {
  const FurModel& model = own.copy.model();
  const std::vector<FurFields> fields = own.copy.fields();
  const std::vector<GrowRecipe> recipes = own.recipes_for(frame);
  std::vector<std::unique_ptr<const Grower>> growers;
  for (std::size_t c = 0; c < recipes.size(); ++c)
    growers.push_back(std::make_unique<const Grower>(model, fields[c], recipes[c]));
  std::vector<std::array<SkinLook, 3>> skin(model.triangles.size());
  for_each_in_parallel(
      static_cast<std::uint32_t>(skin.size()),
      [&](std::uint32_t triangle) {
        std::vector<std::array<SkinLook, 3>> of_each;
        for (const auto& grower : growers) of_each.push_back(grower->skin(triangle));
        skin[triangle] = skin_under(of_each);
      },
      threads);
  return skin;
}

/// Returns the frame as its backplate is drawn: with twice the size if that is at most 2048 pixels a side.
FurFrame plate_of(const FurFrame& frame) {
  constexpr int max_pixels = 2048;  // along a side of a plate that is larger than its frame
  const int factor = 2 * std::max(frame.width, frame.height) <= max_pixels ? 2 : 1;
  FurFrame plate = frame;
  plate.width *= factor, plate.height *= factor, plate.knobs.scale = factor, plate.crop.reset();
  return plate;
}

}  // namespace

FloatImage RasterRenderer::draw_bare(RasterModel& model, const FurFrame& frame,
                                     std::span<const std::array<SkinLook, 3>> skin, RasterOutput shown) const {
  auto picture = empty_picture<FloatImage>(frame.width, frame.height);
  Raster& raster = *model.full.raster;
  const RasterScene scene = raster.bare_scene_of(model.copy.model(), skin, frame, shown);
  RasterCounts counts;
  for (const PixelBox& box : Raster::boxes_of(frame)) raster.draw_box(scene, box, picture, counts);
  return picture;
}

Result<FloatImage> RasterRenderer::shape_overlay(const FurFrame& frame, DrawTimes& times) {
  const DrawClock clock(times);
  try {
    FurFrame bare = frame;
    bare.eyes.clear(), bare.lights.clear(), bare.crop.reset();
    RasterModel& model = *models_.at(frame.model);
    const FurModel& shape = model.copy.model();
    const std::vector<std::array<SkinLook, 3>> skin(shape.triangles.size());
    return shape_picture(frame, shape, draw_bare(model, bare, skin, RasterOutput::normal),
                         draw_bare(model, bare, skin, RasterOutput::triangle), threads_);
  } catch (const std::bad_alloc&) {
    return no_memory_for_frame();
  }
}

Result<Backplate> RasterRenderer::draw_backplate(const FurFrame& frame, DrawTimes& times) {
  const DrawClock clock(times);
  try {
    RasterModel& model = *models_.at(frame.model);
    const std::vector<std::array<SkinLook, 3>> skin = skin_of(model, frame, threads_);
    const FurFrame plate = plate_of(frame);
    const auto draw = [&](RasterOutput shown) { return draw_bare(model, plate, skin, shown); };
    return Backplate{draw(RasterOutput::light), draw(RasterOutput::direct), draw(RasterOutput::albedo),
                     draw(RasterOutput::normal), draw(RasterOutput::depth)};
  } catch (const std::bad_alloc&) {
    return no_memory_for_frame();
  }
}

}  // namespace pelage
