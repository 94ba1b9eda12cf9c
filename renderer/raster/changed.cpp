#include "renderer/raster/changed.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <vector>

#include "protocol/base/clamped_index.h"
#include "protocol/base/parallel.h"
#include "renderer/raster/cull.h"

namespace pelage {

namespace {

PixelBox whole_of(const RasterScene& scene) { return {0, 0, scene.width, scene.height}; }

/// What strands in a block may be drawn over, or its skin.
PixelBox covered(const RasterScene& scene, const GridBlock& block, float thickest) {
  const PictureCamera& camera = scene.camera;
  glm::vec2 first(1e9f), last(-1e9f);
  float nearest = 1e9f;
  for (int k = 0; k < 8; ++k) {
    const glm::vec3 corner = glm::mix(block.low, block.high, glm::vec3(k & 1, k >> 1 & 1, k >> 2)) - camera.position;
    const float distance = glm::dot(corner, camera.forward);
    if (!(distance > 2 * near_distance)) return whole_of(scene);  // it reaches behind the camera
    const glm::vec2 pixel = camera.middle + camera.scale / distance *
                                                glm::vec2(glm::dot(corner, camera.right), -glm::dot(corner, camera.up));
    first = glm::min(first, pixel), last = glm::max(last, pixel), nearest = std::min(nearest, distance);
  }
  const float beside = block.fur ? drawn_beside(scene, thickest, nearest) : 1;
  const auto held = [](float at, int size) { return clamped_index(std::floor(at), 0, size); };
  return {held(first.x - beside, scene.width), held(first.y - beside, scene.height),
          held(last.x + beside + 1, scene.width), held(last.y + beside + 1, scene.height)};
}

/// Strands of a part that are drawn and look another way: they are others, or what shines at the knots of the strand
/// whose light they have is.
void add_strands(const RasterScene& scene, const GrownPart& part, std::span<const std::int32_t> blocks,
                 TileMask& mask) {
  KeptStrands kept;
  keep_strands(scene, part, kept);
  if (kept.ids.empty()) return;
  std::vector<StrandBox> boxes;
  find_changed(scene, part, kept, blocks, boxes);
  const std::uint32_t own = lit_strands(scene, part, kept.ids.back());
  std::vector<std::uint8_t> changed(kept.ids.back() + std::size_t{1}, 1);  // of strands that face away it is not known
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const std::uint32_t id = kept.ids[i];
    const std::uint32_t lit = lit_strand(*part.strands, id, own);
    changed[id] = boxes[i].fur || (lit == id ? boxes[i].light : changed[lit] != 0) ? 1 : 0;
    if (changed[id] != 0)
      boxes[i].bounded ? mask.add(boxes[i].left, boxes[i].top, boxes[i].right, boxes[i].bottom)
                       : mask.add(whole_of(scene));
  }
}

}  // namespace

TileMask changed_since(const RasterScene& scene, std::uint64_t since, int threads) {
  const DensityGrid& grid = *scene.grid;
  TileMask changed(scene.width, scene.height);
  if (grid.all_changed(since) || (scene.near && scene.near->since() > since)) {
    changed.add(whole_of(scene));
    return changed;
  }
  std::vector<const GrownPart*> parts;
  float thickest = 0;
  for (const GrownPart& part : scene.parts) {
    thickest = std::max(thickest, part.thickest);
    if (part.strands->count() > 0 && grid.changed_in(part.low, part.high, since)) parts.push_back(&part);
  }
  const bool near = scene.near && !scene.near->cells().empty();
  const std::vector<std::int32_t> blocks = grid.changed_flags(since, near);
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
