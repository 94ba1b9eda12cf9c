#include "renderer/marched/shadow_cache.h"

#include <algorithm>
#include <cmath>

#include "protocol/base/clamped_index.h"
#include "renderer/marched/fur_hull.h"
#include "renderer/marched/shadow_width.h"

namespace pelage {

namespace {

constexpr float nowhere = 1e30f;  // depth of the nearest curve where there is none, sizes

bool casts(const FurLight& light) { return light.cast_shadow != CastShadow::none; }
ShadowEdge edge_of(CastShadow cast) {
  switch (cast) {
    case CastShadow::none: return ShadowEdge::none;
    case CastShadow::hard: return ShadowEdge::hard;
    case CastShadow::soft: return ShadowEdge::soft;
    case CastShadow::penumbra: return ShadowEdge::penumbra;
  }
  return ShadowEdge::none;
}
bool has_maps(const FurLight& light) { return light.self_shadow_maps || casts(light); }

/// What curves let through, and the depth of the nearest, for each texel.
std::vector<glm::vec2> curve_map(const CurveStrips& strips, const LightView& light, int side) {
  std::vector<glm::vec2> map(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), glm::vec2(1, nowhere));
  const RibbonCamera camera{light.world_to_clip, light.viewpoint, light.texel, glm::vec2(static_cast<float>(side))};
  for (const Ribbon& ribbon : ribbons_of(strips, camera)) {
    const float reach = std::max(ribbon.root.reach, ribbon.tip.reach) + 1.5f;
    const glm::vec2 low = glm::min(ribbon.root.at, ribbon.tip.at) - reach,
                    high = glm::max(ribbon.root.at, ribbon.tip.at) + reach;
    for (int y = clamped_index(low.y, 0, side); y < clamped_index(high.y, 0, side); ++y) {
      for (int x = clamped_index(low.x, 0, side); x < clamped_index(high.x, 0, side); ++x) {
        const OnRibbon on = on_ribbon(ribbon, {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
        if (on.opacity < 0.004f) continue;
        const glm::vec3 place = glm::mix(ribbon.root.place, ribbon.tip.place, on.share);
        glm::vec2& texel =
            map[static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x)];
        texel = {texel.x * (1 - on.opacity), std::min(texel.y, glm::dot(glm::vec3(light.axis), place) + light.axis.w)};
      }
    }
  }
  return map;
}

}  // namespace

bool ShadowCache::wanted(const FurFrame& frame) {
  return frame.knobs.shadow_maps && std::any_of(frame.lights.begin(), frame.lights.end(), has_maps);
}

void ShadowCache::add(const FurFrame& frame, std::uint64_t changes, const CurveStrips& curves, int threads,
                      MarchScene& scene) {
  if (!wanted(frame)) return;
  Key key{frame.model,  changes,      frame.coat.root_share,        frame.coat.lean_curve,
          frame.lights, frame.curves, frame.knobs.shadow_resolution};
  if (key != key_) {
    key_ = {};  // of nothing, should memory end while they are made
    make_maps(frame, curves, threads, scene);
    key_ = std::move(key);
  }
  scene.optics.casters = casters_;
}

void ShadowCache::make_maps(const FurFrame& frame, const CurveStrips& curves, int threads, const MarchScene& scene) {
  const MarchMesh& mesh = scene.mesh;
  const int side = frame.knobs.shadow_resolution;
  const float radius = radius_of_fur(mesh);
  casters_.assign(frame.lights.size(), {});
  maps_.assign(frame.lights.size(), {});
  for (std::size_t i = 0; i < frame.lights.size(); ++i) {
    const FurLight& light = frame.lights[i];
    const auto view = has_maps(light) ? view_of_light(light, radius, side) : std::nullopt;
    if (!view) continue;
    Maps& maps = maps_[i];
    ShadowCaster& caster = casters_[i];
    caster.to_light = view->world_to_clip, caster.axis = view->axis, caster.edge = edge_of(light.cast_shadow);
    caster.spread = spread_of(light), caster.scale = light.shadow_scale, caster.side = side;
    maps.depths = light.cast_shadow == CastShadow::penumbra
                      ? draw_depth_map(fur_hull(mesh, frame.coat), mesh.triangles, *view, side, threads)
                      : draw_depth_map(mesh.positions, mesh.triangles, *view, side, threads);
    caster.depths = maps.depths.depths.data();
    if (light.cast_shadow == CastShadow::soft) {
      maps.widths =
          shadow_widths(occlusion_map(mesh.positions, mesh.normals, mesh.triangles, *view, maps.depths, threads), side);
      caster.widths = maps.widths.data(), caster.width_side = shadow_width_side(side);
    }
    if (casts(light) && !frame.curves.empty())
      maps.curves = curve_map(curves, *view, side), caster.curves = maps.curves.data();
  }
}

}  // namespace pelage
