#include "renderer/raster/gpu/strand_plan.h"

#include "renderer/raster/cull.h"

namespace pelage {

namespace {

PlannedPart planned_part(const RasterScene& scene, const GrownPart& part, PooledStrands pooled) {
  const StrandCull cull = strand_cull(scene, part);
  PlannedPart planned;
  planned.to_camera = cull.to_camera, planned.min_facing = cull.min_facing;
  planned.points = pooled.points, planned.words = pooled.words;
  planned.count = static_cast<std::uint32_t>(part.strands->count()), planned.kept = cull.count;
  planned.exact = static_cast<float>(cull.exact), planned.width_factor = static_cast<float>(cull.width_factor);
  planned.segments = part.strands->segments;
  planned.is_curve = part.role == StrandRole::curve, planned.has_mean = !part.strands->to_mean.empty();
  planned.lit_of = strands_of_lit(scene, part), planned.own_colour = own_colour(scene, part);
  planned.wider = part.wider, planned.packing = part.packing, planned.crowding = part.crowding;
  planned.coat = coat_number(part);
  return planned;
}

}  // namespace

StrandPlan strand_plan(const RasterScene& scene, const PixelBox& box, const StrandPool& pool) {
  StrandPlan plan;
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const GrownPart& part = scene.parts[i];
    const std::uint32_t first_number = number;
    number += static_cast<std::uint32_t>(part.strands->count());
    if (!shows_in(scene, part, box)) continue;
    PlannedPart planned = planned_part(scene, part, pool.at(i));
    planned.first = plan.strands(), planned.number = first_number;
    const auto at = static_cast<std::uint32_t>(plan.parts.size());
    for (std::uint32_t strand = 0; strand < planned.kept; strand += strand_group) plan.groups.emplace_back(at, strand);
    plan.parts.push_back(planned);
  }
  return plan;
}

}  // namespace pelage
