#include "renderer/raster/gpu/scene_data.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace pelage {

void SceneData::send_azimuthal(const AzimuthalFit& fit) {
  std::vector<std::int32_t> sent{fit.azimuths, fit.inclinations};
  sent.insert(sent.end(), fit.nodes.begin(), fit.nodes.end());
  azimuthal.send(std::span<const std::int32_t>(sent));
}

void SceneData::send_eyes(const EyeOptics& optics) {
  if (!optics.tissues) return;
  eyes.send(std::span<const EyeBlock>(&optics.block, 1));
  if (tissues.bytes() < optics.tissues->words.size())
    tissues.send(std::span<const std::int32_t>(optics.tissues->words));  // the tissue is the same for all eyes
  caustics.send(optics.caustics);
}

void SceneData::send_plan(const StrandPlan& strands) {
  const std::size_t parts_at = max_strand_groups * sizeof(glm::uvec2);
  plan.reserve(parts_at + std::max<std::size_t>(strands.parts.size(), 1) * sizeof(PlannedPart));
  plan.send_at(0, std::span<const glm::uvec2>(strands.groups));
  plan.send_at(parts_at, std::span<const PlannedPart>(strands.parts));
}

void SceneData::send(const DrawnBox& box) {
  const RasterScene& scene = box.scene;
  frame_.send(frame_binding, scene.optics.frame), scattering_.send(scattering_binding, scene.optics.scattering);
  skin_.send(skin_binding, scene.optics.skin);
  model.update(scene), cells.prepare(scene, pool, std::exchange(strands_changed_, false));
  send_azimuthal(*scene.optics.azimuthal);
  send_eyes(scene.optics.eyes);
  std::vector<std::uint32_t> flags(static_cast<std::size_t>(box.tiles.count()), 1);
  for (std::size_t tile = 0; scene.drawn && tile < flags.size(); ++tile) {
    const int x = static_cast<int>(tile) % box.tiles.across, y = static_cast<int>(tile) / box.tiles.across;
    flags[tile] = scene.drawn->has(box.pixels.left + x * tile_side, box.pixels.top + y * tile_side);
  }
  drawn.send(std::span<const std::uint32_t>(flags));
}

}  // namespace pelage
