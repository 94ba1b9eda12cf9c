#include "renderer/upload/skin_block.h"

#include <algorithm>
#include <cassert>

namespace pelage {

namespace {

SkinEntry make_entry(const FurSkinRegion& region) {
  const glm::dmat3 rows = glm::transpose(region.to_unit);
  const double steepest = std::max({glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2])});
  SkinEntry entry;
  entry.across = glm::vec4(rows[0], region.softness);
  entry.up = glm::vec4(rows[1], steepest);
  entry.along = glm::vec4(rows[2], region.cosine_whole);
  entry.centre = glm::vec4(region.centre, region.scatter);
  entry.facing = glm::vec4(region.facing, std::min(region.cosine_none, region.cosine_whole - 1e-6));
  entry.colour = glm::vec4(region.colour, region.shine);
  entry.finish = glm::vec4(region.roughness, region.wetness, region.bumps.height, region.bumps.size);
  return entry;
}

/// Twice the largest radius, or to where the colour ends beyond that; a little more for rounding.
glm::vec4 ball_around(const FurSkinRegion& region) {
  const glm::dmat3 rows = glm::transpose(region.to_unit);
  const double flattest = std::min({glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2])});
  const double radius = 1.001 * (1 + std::max(1.0, 0.5 * region.softness)) / flattest;
  return glm::vec4(region.centre, radius * radius);
}

}  // namespace

SkinBlock make_skin_block(std::span<const FurSkinRegion> regions) {
  assert(regions.size() <= limits::skin_regions);
  SkinBlock block;
  block.count.x = static_cast<glm::uint>(regions.size());
  std::transform(regions.begin(), regions.end(), block.regions.begin(), make_entry);
  std::transform(regions.begin(), regions.end(), block.balls.begin(), ball_around);
  return block;
}

}  // namespace pelage
