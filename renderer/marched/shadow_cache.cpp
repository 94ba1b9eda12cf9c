#include "renderer/marched/shadow_cache.h"

#include <algorithm>
#include <cmath>

#include "protocol/base/lean_curve.h"

namespace pelage {

namespace {

constexpr float half_diagonal = 0.5f;  // of every model's box, sizes
constexpr float nowhere = 1e30f;       // depth of the nearest curve where there is none, sizes

bool casts(const FurLight& light) { return light.cast_shadow != CastShadow::none; }

/// Places of the fur's hull over the mesh's vertices.
std::vector<glm::vec3> hull_of(const MarchMesh& mesh, LeanCurve curve, double root_share) {
  std::vector<glm::vec3> places(mesh.positions.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Lean<float> lean = lean_of(glm::vec2(mesh.groom[i]), mesh.normals[i], mesh.tangents[i]);
    const LeanPoint point = lean_point(curve, double{lean.inclination}, root_share, double{hull_height});
    const glm::vec3 way =
        static_cast<float>(point.across) * lean.along + static_cast<float>(point.up) * mesh.normals[i];
    places[i] = mesh.positions[i] + mesh.groom[i].z * way;
  }
  return places;
}

/// What curves let through, and the depth of the nearest, for each texel.
std::vector<glm::vec2> curve_map(const CurveStrips& strips, const LightView& light, int side) {
  std::vector<glm::vec2> map(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), glm::vec2(1, nowhere));
  const RibbonCamera camera{light.world_to_clip, light.viewpoint, light.texel, glm::vec2(static_cast<float>(side))};
  for (const Ribbon& ribbon : ribbons_of(strips, camera)) {
    const float reach = std::max(ribbon.root.reach, ribbon.tip.reach) + 1.5f;
    const glm::vec2 low = glm::max(glm::min(ribbon.root.at, ribbon.tip.at) - reach, 0.0f),
                    high = glm::min(glm::max(ribbon.root.at, ribbon.tip.at) + reach, static_cast<float>(side));
    for (int y = static_cast<int>(low.y); y < static_cast<int>(high.y); ++y) {
      for (int x = static_cast<int>(low.x); x < static_cast<int>(high.x); ++x) {
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

bool ShadowCache::makes_all(const FurFrame& frame) {
  return !frame.knobs.shadow_maps || std::all_of(frame.lights.begin(), frame.lights.end(), [](const FurLight& light) {
    return !light.self_shadow_maps && (!casts(light) || light.cast_shadow == CastShadow::penumbra);
  });
}

void ShadowCache::add(const FurFrame& frame, std::uint64_t changes, const CurveStrips& curves, MarchScene& scene) {
  if (!frame.knobs.shadow_maps || std::none_of(frame.lights.begin(), frame.lights.end(), casts)) return;
  const LeanCurve curve = scene.optics.frame.tile.z > 0.5f ? LeanCurve::root : LeanCurve::arc;
  Key key{frame.model,  changes,      frame.coat.root_share,        curve,
          frame.lights, frame.curves, frame.knobs.shadow_resolution};
  if (key != key_) {
    key_ = std::move(key);
    make_maps(frame, curves, scene);
  }
  scene.optics.casters = casters_;
}

void ShadowCache::make_maps(const FurFrame& frame, const CurveStrips& curves, const MarchScene& scene) {
  const std::vector<glm::vec3> hull = hull_of(scene.mesh, key_.curve, key_.root_share);
  const int side = key_.resolution;
  float longest = 0;
  for (const glm::vec3& groom : scene.mesh.groom) longest = std::max(longest, groom.z);
  casters_.assign(frame.lights.size(), {});
  depths_.assign(frame.lights.size(), {}), curves_.assign(frame.lights.size(), {});
  for (std::size_t i = 0; i < frame.lights.size(); ++i) {
    const FurLight& light = frame.lights[i];
    const auto view = casts(light) ? view_of_light(light, half_diagonal + longest, side) : std::nullopt;
    if (!view) continue;
    depths_[i] = draw_depth_map(hull, scene.mesh.triangles, *view, side);
    if (!frame.curves.empty()) curves_[i] = curve_map(curves, *view, side);
    casters_[i] = {view->world_to_clip,      view->axis,
                   spread_of(light),         side,
                   depths_[i].depths.data(), curves_[i].empty() ? nullptr : curves_[i].data()};
  }
}

}  // namespace pelage
