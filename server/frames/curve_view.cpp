#include "server/frames/curve_view.h"

#include <algorithm>

#include "protocol/base/lean_curve.h"

namespace pelage {

namespace {

/// How far the tips of the fur stand above the skin, sizes.
double fur_height(const SceneView& scene, const SurfacePoint& point) {
  const Coat& coat = scene.settings.coat;
  const glm::uvec3 corners = scene.model.surface.mesh().triangles[point.triangle];
  double height = 0;
  for (int k = 0; k < 3; ++k) {
    const Groom groom = scene.fields.at(corners[k]);
    const double inclination = std::min(glm::length(glm::dvec2(groom.direction)), 1.0);
    height += point.barycentric[k] * groom.length * lean_point(coat.lean_curve, inclination, coat.root_share, 1).up;
  }
  return std::max(height, 0.0);
}

FurGuide make_guide(const GuideCurve& curve, const SceneView& scene) {
  const Surface& surface = scene.model.surface;
  FurGuide guide;
  for (const glm::dvec3& point : curve) guide.points.push_back(surface.mesh().to_internal(point));
  const SurfacePoint root = surface.nearest(guide.points.front());
  guide.skin = surface.position(root), guide.normal = surface.normal(root);
  guide.fur_height = fur_height(scene, root);
  return guide;
}

}  // namespace

FurCurves make_curves(const CurveGroup& group, const SceneView& scene) {
  FurCurves made;
  for (const GuideCurve& curve : group.curves) made.guides.push_back(make_guide(curve, scene));
  made.width_root = group.width_root, made.width_tip = group.width_tip;
  made.root_colour = group.root_colour, made.tip_colour = group.tip_colour;
  made.fill = group.fill, made.spread = group.spread, made.seed = group.seed;
  return made;
}

}  // namespace pelage
