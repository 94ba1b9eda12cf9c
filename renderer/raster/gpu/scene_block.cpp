#include "renderer/raster/gpu/scene_block.h"

#include <algorithm>

namespace pelage {

namespace {

void add_grid(const RasterScene& scene, SceneBlock& block) {
  if (!scene.cells) return;
  const GridLayout& layout = *scene.cells;
  block.grid_there = 1, block.grid_low = layout.low, block.grid_cell = layout.cell, block.grid_size = layout.size;
  block.near_cell = near_cell_side(layout.cell);
}

void add_ground(const RasterScene& scene, SceneBlock& block) {
  if (!scene.ground) return;
  block.ground_height = scene.ground->height, block.ground_contact = scene.ground->contact;
  block.ground_shadow = scene.ground->shadow;
  const SkyOverGround sky = sky_map(*scene.cells);
  block.sky_low = sky.low, block.sky_cell = sky.cell, block.sky_size = sky.size;
}

}  // namespace

SceneBlock scene_block(const RasterScene& scene, const PixelBox& box, std::uint32_t strands,
                       const StageCapacities& rooms) {
  const PictureCamera& camera = scene.camera;
  const FrameOptics& optics = scene.optics;
  const TileRows tiles = tiles_of(box);
  SceneBlock block;
  block.camera_position = camera.position, block.camera_scale = camera.scale, block.camera_right = camera.right;
  block.camera_up = camera.up, block.camera_forward = camera.forward, block.camera_middle = camera.middle;
  block.oversampling = scene.oversampling, block.wetness = optics.wetness;
  block.over_view = static_cast<float>(std::max(scene.width, scene.height)) / camera.scale;
  block.tiles = {tiles.across, tiles.down}, block.box = {box.left, box.top, box.right, box.bottom};
  add_grid(scene, block), add_ground(scene, block);
  block.directional_lights = optics.directional_lights, block.shading_model = optics.model;
  block.light_count = static_cast<std::uint32_t>(optics.lights);
  block.key_furthest = scene.keys.furthest, block.key_shift = scene.keys.shift;
  block.triangle_count = static_cast<std::uint32_t>(scene.model->triangles.size()), block.strand_count = strands;
  block.knot_capacity = rooms.knots, block.entry_capacity = rooms.entries, block.lit_point_capacity = rooms.lit_points;
  block.texel_levels = optics.images ? static_cast<std::uint32_t>(optics.images->levels.size()) : 0;
  block.model_colours = optics.model_colours;
  block.eye_count = static_cast<std::int32_t>(scene.eyes.size()), block.eye_steps = optics.eyes.steps;
  for (std::size_t i = 0; i < scene.light_sizes.size(); ++i)
    block.light_widths[i] = {scene.light_sizes[i].radius, scene.light_sizes[i].far ? 1 : 0, 0, 0};
  for (std::size_t i = 0; i < scene.eyes.size(); ++i) {
    const PixelBox& around = scene.eyes[i].box;
    block.eye_boxes[i] = {around.left, around.top, around.right, around.bottom};
  }
  return block;
}

}  // namespace pelage
