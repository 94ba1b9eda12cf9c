#include "server/frames/skin_view.h"

#include <algorithm>
#include <cmath>

#include "server/scene/eye_view.h"

namespace pelage {

namespace {

FurSkinRegion make_region(const SkinRegion& region, const Mesh& mesh) {
  FurSkinRegion made;
  made.centre = mesh.to_internal(region.centre);
  const glm::dmat3 frame = tilted(upright_frame(region.axis), glm::radians(region.turn_degrees));
  const glm::dmat3 shrunk{frame[0] / region.radii.x, frame[1] / region.radii.y, frame[2] / region.radii.z};
  made.to_unit = glm::transpose(shrunk);
  made.softness = region.softness;
  if (region.facing) {
    const SkinFacing& facing = *region.facing;
    made.facing = glm::normalize(facing.direction);
    made.cosine_whole = std::cos(glm::radians(facing.angle_degrees)) - 1e-6;  // whole at 180 degrees after rounding
    made.cosine_none = std::cos(glm::radians(std::min(180.0, facing.angle_degrees + facing.fade_degrees)));
  }
  made.colour = region.colour;
  made.shine = region.shine, made.roughness = region.roughness;
  made.wetness = region.wetness, made.scatter = region.scatter;
  made.bumps = region.bumps;
  return made;
}

}  // namespace

std::vector<FurSkinRegion> make_skin(const std::vector<SkinRegion>& regions, const Mesh& mesh) {
  std::vector<FurSkinRegion> made;
  made.reserve(regions.size());
  for (const SkinRegion& region : regions) made.push_back(make_region(region, mesh));
  return made;
}

}  // namespace pelage
