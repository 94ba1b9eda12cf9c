#include "renderer/marched/ribbons.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "protocol/base/clamped_index.h"
#include "renderer/marched/march_scene.h"

namespace pelage {

namespace {

constexpr std::size_t points_each = curve_segments + 1;

/// Pixels of a place that is not nearer than near_distance.
glm::vec2 on_picture(const RibbonCamera& camera, const glm::vec4& clip) {
  return (glm::vec2(clip.x, -clip.y) / clip.w * 0.5f + 0.5f) * camera.size;
}

RibbonEnd end_of(const CurveStrips& strips, std::size_t curve, std::size_t at, const RibbonCamera& camera) {
  const std::size_t root = curve * points_each;
  const CurveStyle& style = strips.styles[curve];
  const std::size_t before = at == 0 ? at : at - 1, after = std::min(at + 1, points_each - 1);
  const glm::vec3 tangent = unit_of(strips.points[root + after].place - strips.points[root + before].place);
  const glm::vec4 looks = glm::mix(style.root, style.tip, static_cast<float>(at) / curve_segments);
  RibbonEnd end = ribbon_end(strips.points[root + at].place, tangent, looks.w, camera);
  end.colour = looks;
  return end;
}

}  // namespace

RibbonEnd ribbon_end(glm::vec3 place, glm::vec3 tangent, float width, const RibbonCamera& camera) {
  RibbonEnd end;
  end.place = place, end.tangent = tangent;
  const glm::mat4& to_clip = camera.to_clip;
  const glm::vec4 clip = to_clip * glm::vec4(end.place, 1);
  if (!(clip.w > near_distance)) return end;
  end.inverse = 1 / clip.w, end.at = on_picture(camera, clip);
  const glm::vec3 to_camera = camera.viewpoint - end.place;
  const float pixel = camera.pixel * glm::length(to_camera), pixels = width / std::max(pixel, 1e-20f);
  end.reach = 0.5f * std::max(pixels, 1.0f), end.strength = std::min(pixels, 1.0f);
  const glm::vec3 spread = unit_of(glm::cross(end.tangent, unit_of(to_camera)));
  const glm::vec4 aside = to_clip * glm::vec4(end.place + spread * pixel, 1);
  if (!(aside.w > near_distance)) return end;
  const glm::vec2 across = on_picture(camera, aside) - end.at;
  const glm::vec4 ahead = to_clip * glm::vec4(end.place + end.tangent * pixel, 1);
  end.along = glm::vec2(across.y, -across.x) / std::max(glm::length(across), 1e-20f);
  if (ahead.w > near_distance && glm::dot(end.along, on_picture(camera, ahead) - end.at) < 0) end.along = -end.along;
  return end;
}

std::vector<Ribbon> ribbons_of(const CurveStrips& strips, const RibbonCamera& camera) {
  std::vector<Ribbon> ribbons;
  for (std::size_t curve = 0; curve < strips.styles.size(); ++curve) {
    RibbonEnd root = end_of(strips, curve, 0, camera);
    for (std::size_t at = 1; at < points_each; ++at) {
      const RibbonEnd tip = end_of(strips, curve, at, camera);
      if (root.inverse > 0 && tip.inverse > 0)
        ribbons.push_back({root, tip, strips.styles[curve].normal, strips.styles[curve].normal.w});
      root = tip;
    }
  }
  return ribbons;
}

OnRibbon on_ribbon(const Ribbon& ribbon, glm::vec2 pixel) {
  const RibbonEnd &a = ribbon.root, &b = ribbon.tip;
  const float from_root = glm::dot(pixel - a.at, a.along), past_tip = glm::dot(pixel - b.at, b.along);
  if (!(from_root >= 0 && past_tip < 0)) return {};
  const float share = std::clamp(from_root / std::max(from_root - past_tip, 1e-12f), 0.0f, 1.0f);
  const glm::vec2 way = b.at - a.at, off = pixel - a.at;
  const float across = std::abs(off.x * way.y - off.y * way.x) / std::max(glm::length(way), 1e-12f);
  return {share, glm::mix(a.strength, b.strength, share) *
                     std::clamp(glm::mix(a.reach, b.reach, share) + 0.5f - across, 0.0f, 1.0f)};
}

Ribbons::Ribbons(std::vector<Ribbon> ribbons, const MarchScene& scene) : ribbons_(std::move(ribbons)) {
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
      return std::clamp(clamped_index(std::floor(pixel / Tile::side), -1, 1'000'000) - first, -1, count);
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
