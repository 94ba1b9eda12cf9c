#include "renderer/marched/ribbons.h"

#include <algorithm>
#include <cmath>

#include "renderer/marched/march_scene.h"

namespace pelage {

namespace {

constexpr std::size_t points_each = curve_segments + 1;

glm::vec3 unit_of(glm::vec3 v) { return v / std::max(glm::length(v), 1e-20f); }

/// Pixels of a place that is not nearer than near_distance.
glm::vec2 on_picture(const MarchScene& scene, const glm::vec4& clip) {
  return (glm::vec2(clip.x, -clip.y) / clip.w * 0.5f + 0.5f) * glm::vec2(scene.width, scene.height);
}

RibbonEnd end_of(const CurveStrips& strips, std::size_t curve, std::size_t at, const MarchScene& scene) {
  const std::size_t root = curve * points_each;
  const CurveStyle& style = strips.styles[curve];
  RibbonEnd end;
  end.place = strips.points[root + at].place;
  const std::size_t before = at == 0 ? at : at - 1, after = std::min(at + 1, points_each - 1);
  end.tangent = unit_of(strips.points[root + after].place - strips.points[root + before].place);
  const glm::vec4 looks = glm::mix(style.root, style.tip, static_cast<float>(at) / curve_segments);
  end.colour = looks;
  const glm::mat4& to_clip = scene.optics.frame.world_to_clip;
  const glm::vec4 clip = to_clip * glm::vec4(end.place, 1);
  if (!(clip.w > near_distance)) return end;
  end.inverse = 1 / clip.w, end.at = on_picture(scene, clip);
  const glm::vec3 to_camera = scene.viewpoint - end.place;
  const float pixel = scene.optics.frame.viewpoint.w * glm::length(to_camera),
              pixels = looks.w / std::max(pixel, 1e-20f);
  end.reach = 0.5f * std::max(pixels, 1.0f), end.strength = std::min(pixels, 1.0f);
  const glm::vec3 spread = unit_of(glm::cross(end.tangent, unit_of(to_camera)));
  const glm::vec4 aside = to_clip * glm::vec4(end.place + spread * pixel, 1);
  if (!(aside.w > near_distance)) return end;
  const glm::vec2 across = on_picture(scene, aside) - end.at;
  const glm::vec4 ahead = to_clip * glm::vec4(end.place + end.tangent * pixel, 1);
  end.along = glm::vec2(across.y, -across.x) / std::max(glm::length(across), 1e-20f);
  if (ahead.w > near_distance && glm::dot(end.along, on_picture(scene, ahead) - end.at) < 0) end.along = -end.along;
  return end;
}

}  // namespace

Ribbons::Ribbons(const CurveStrips& strips, const MarchScene& scene) {
  for (std::size_t curve = 0; curve < strips.styles.size(); ++curve) {
    RibbonEnd root = end_of(strips, curve, 0, scene);
    for (std::size_t at = 1; at < points_each; ++at) {
      const RibbonEnd tip = end_of(strips, curve, at, scene);
      if (root.inverse > 0 && tip.inverse > 0)
        ribbons_.push_back({root, tip, strips.styles[curve].normal, strips.styles[curve].normal.w});
      root = tip;
    }
  }
  sort_into_tiles(scene);
}

void Ribbons::sort_into_tiles(const MarchScene& scene) {
  const glm::ivec2 begin = glm::ivec2(scene.box.left, scene.box.top) / Tile::side,
                   end = (glm::ivec2(scene.box.right, scene.box.bottom) + Tile::side - 1) / Tile::side;
  const glm::ivec2 tiles = end - begin;
  std::vector<std::vector<std::uint32_t>> lists(static_cast<std::size_t>(tiles.x) * static_cast<std::size_t>(tiles.y));
  for (std::uint32_t i = 0; i < ribbons_.size(); ++i) {
    const RibbonEnd &a = ribbons_[i].root, &b = ribbons_[i].tip;
    const float reach = std::max(a.reach, b.reach) + 1.5f;
    const auto tile_at = [&](float pixel, int first, int count) {
      return std::clamp(static_cast<int>(std::floor(std::clamp(pixel / Tile::side, -1.0f, 1e6f))) - first, -1, count);
    };
    const glm::vec2 low = glm::min(a.at, b.at) - reach, high = glm::max(a.at, b.at) + reach;
    const int bottom = std::min(tile_at(high.y, begin.y, tiles.y), tiles.y - 1),
              right = std::min(tile_at(high.x, begin.x, tiles.x), tiles.x - 1);
    for (int y = std::max(tile_at(low.y, begin.y, tiles.y), 0); y <= bottom; ++y) {
      for (int x = std::max(tile_at(low.x, begin.x, tiles.x), 0); x <= right; ++x)
        lists[static_cast<std::size_t>(y * tiles.x + x)].push_back(i);
    }
  }
  first_.push_back(0);
  for (const std::vector<std::uint32_t>& list : lists) {
    numbers_.insert(numbers_.end(), list.begin(), list.end());
    first_.push_back(static_cast<std::uint32_t>(numbers_.size()));
  }
}

}  // namespace pelage
