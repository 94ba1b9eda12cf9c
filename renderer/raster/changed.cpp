#include "renderer/raster/changed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <vector>

#include "base/clamped_index.h"
#include "base/parallel.h"
#include "renderer/raster/cull.h"

namespace pelage {

namespace {

PixelBox full_box(const RasterScene& scene) { return {0, 0, scene.width, scene.height}; }

using Corners = std::array<glm::vec3, 8>;  // corners of a block, relative to the camera: right, up, forward

Corners corners_of(const PictureCamera& camera, const GridBlock& block) {
  Corners corners;
  for (int k = 0; k < 8; ++k) {
    const glm::vec3 apart = glm::mix(block.low, block.high, glm::vec3(k & 1, k >> 1 & 1, k >> 2)) - camera.position;
    corners[static_cast<std::size_t>(k)] = {glm::dot(apart, camera.right), glm::dot(apart, camera.up),
                                            glm::dot(apart, camera.forward)};
  }
  return corners;
}

/// Returns whether a block, with the margin that its strands may be drawn in, lies behind the camera or beyond one edge
/// of the picture. Tests planes through the camera, which also hold for blocks that reach behind it.
bool is_out_of_view(const RasterScene& scene, const Corners& corners, float thickest) {
  const PictureCamera& camera = scene.camera;
  const float edge = drawn_beside(scene, 0, 1), wide = drawn_beside(scene, thickest, 1);
  const auto past = [&](glm::vec2 axis, float pixels) {
    return std::all_of(corners.begin(), corners.end(), [&](glm::vec3 corner) {
      return camera.scale * glm::dot(axis, glm::vec2(corner)) > (pixels + edge) * corner.z + wide;
    });
  };
  return std::all_of(corners.begin(), corners.end(), [](glm::vec3 corner) { return corner.z <= near_distance; }) ||
         past({1, 0}, static_cast<float>(scene.width) - camera.middle.x) || past({-1, 0}, camera.middle.x) ||
         past({0, -1}, static_cast<float>(scene.height) - camera.middle.y) || past({0, 1}, camera.middle.y);
}

/// Returns the pixels that the strands or the skin in a block may cover.
PixelBox covered(const RasterScene& scene, const GridBlock& block, float thickest) {
  const PictureCamera& camera = scene.camera;
  const Corners corners = corners_of(camera, block);
  if (is_out_of_view(scene, corners, thickest)) return {};
  glm::vec2 first(1e9f), last(-1e9f);
  float nearest = 1e9f;
  for (const glm::vec3& corner : corners) {
    if (!(corner.z > 2 * near_distance)) return full_box(scene);  // it reaches behind the camera
    const glm::vec2 pixel = camera.middle + camera.scale / corner.z * glm::vec2(corner.x, -corner.y);
    first = glm::min(first, pixel), last = glm::max(last, pixel), nearest = std::min(nearest, corner.z);
  }
  const float beside = block.fur ? drawn_beside(scene, thickest, nearest) : 1;
  const auto clamp_to = [](float at, int size) { return clamped_index(std::floor(at), 0, size); };
  return {clamp_to(first.x - beside, scene.width), clamp_to(first.y - beside, scene.height),
          clamp_to(last.x + beside + 1, scene.width), clamp_to(last.y + beside + 1, scene.height)};
}

/// Marks the tiles of a part's drawn strands that may look different: they have changed themselves, or the light at the
/// knots of their lit strand has.
void add_strands(const RasterScene& scene, const GrownPart& part, std::span<const std::int32_t> blocks,
                 TileMask& mask) {
  KeptStrands kept;
  keep_strands(scene, part, kept);
  if (kept.ids.empty()) return;
  std::vector<StrandBox> boxes;
  find_changed(scene, part, kept, blocks, boxes);
  const std::uint32_t own = lit_strands(scene, part, kept.ids.back());
  std::vector<std::uint8_t> changed(kept.ids.back() + std::size_t{1}, 1);  // stays 1 for strands that are not kept
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const std::uint32_t id = kept.ids[i];
    const std::uint32_t lit = lit_strand(*part.strands, id, own);
    changed[id] = boxes[i].fur || (lit == id ? boxes[i].light : changed[lit] != 0) ? 1 : 0;
    if (changed[id] != 0) mask.add(boxes[i].left, boxes[i].top, boxes[i].right, boxes[i].bottom);
  }
}

}  // namespace

TileMask changed_since(const RasterScene& scene, std::uint64_t since, int threads) {
  const DensityGrid& grid = *scene.grid;
  TileMask changed(scene.width, scene.height);
  if (grid.all_changed(since) || (scene.near && scene.near->since() > since)) {
    changed.add(full_box(scene));
    return changed;
  }
  std::vector<const GrownPart*> parts;
  float thickest = 0;
  for (const GrownPart& part : scene.parts) {
    thickest = std::max(thickest, part.thickest);
    if (part.strands->count() > 0 && grid.changed_in(part.low, part.high, since)) parts.push_back(&part);
  }
  const std::vector<std::int32_t> blocks = grid.changed_flags(since);
  std::mutex mutex;
  for_each_in_parallel(
      static_cast<std::uint32_t>(parts.size()),
      [&](std::uint32_t i) {
        TileMask own(scene.width, scene.height);
        add_strands(scene, *parts[i], blocks, own);
        const std::lock_guard lock(mutex);
        changed.add(own);
      },
      threads);
  for (const GridBlock& block : grid.changed_blocks(since)) changed.add(covered(scene, block, thickest));
  return changed;
}

}  // namespace pelage
