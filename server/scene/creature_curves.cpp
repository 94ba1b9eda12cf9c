#include "server/scene/creature_curves.h"

#include <cmath>

#include "server/scene/eye_view.h"
#include "server/builtin/creature.h"

namespace pelage {

namespace {

using glm::dvec3;

/// A long hair in model coordinates, on the +X side.
struct Hair {
  dvec3 root;       // near the skin
  dvec3 direction;  // at the root, any length but 0
  double length;
  dvec3 bends;      // how far the tip ends from a straight hair's, in lengths
};

/// Rooted in the skin; `side` is 1, or -1 for its mirror image.
GuideCurve guide_of(const Hair& hair, double side, const Surface& surface) {
  const dvec3 mirror(side, 1, 1);
  const Mesh& mesh = surface.mesh();
  const dvec3 root = mesh.to_model(surface.position(surface.nearest(mesh.to_internal(mirror * hair.root))));
  const dvec3 along = glm::normalize(hair.direction);
  GuideCurve points;
  for (const double t : {0.0, 0.3, 0.65, 1.0})
    points.push_back(root + hair.length * mirror * (t * along + t * t * hair.bends));
  return points;
}

CurveGroup row_of(const std::vector<Hair>& hairs, double side, const Surface& surface) {
  CurveGroup group;
  for (const Hair& hair : hairs) group.curves.push_back(guide_of(hair, side, surface));
  group.seed = side > 0 ? 1 : 2;
  return group;
}

CurveGroup whiskers(const std::vector<Hair>& row, double side, const Surface& surface) {
  CurveGroup group = row_of(row, side, surface);
  group.fill = 2;
  group.spread = 0.25;
  group.width_root = 0.00095, group.width_tip = 0.00012;
  group.root_colour = {0.62f, 0.57f, 0.50f}, group.tip_colour = {0.90f, 0.88f, 0.84f};
  return group;
}

/// Eight whiskers: four in an upper row and four in a lower one, the longest behind.
void add_whiskers(double side, const Surface& surface, std::vector<CurveGroup>& groups) {
  const std::vector<Hair> upper{{{.050, .796, .614}, {1, .24, .46}, .17, {-.02, -.20, -.26}},
                                {{.077, .808, .560}, {1, .56, .04}, .25, {-.02, -.30, -.22}}};
  const std::vector<Hair> lower{{{.052, .777, .610}, {1, -.26, .38}, .14, {-.02, -.20, -.22}},
                                {{.079, .786, .553}, {1, .14, -.04}, .24, {-.02, -.24, -.20}}};
  groups.push_back(whiskers(upper, side, surface));
  groups.push_back(whiskers(lower, side, surface));
}

void add_brow(double side, const Surface& surface, std::vector<CurveGroup>& groups) {
  const std::vector<Hair> hairs{{{.058, .925, .528}, {.15, 1, .75}, .085, {.10, -.10, -.35}},
                                {{.098, .925, .515}, {.55, 1, .60}, .10, {.14, -.14, -.35}}};
  CurveGroup group = row_of(hairs, side, surface);
  group.fill = 2;
  group.spread = 0.35;
  group.width_root = 0.0008, group.width_tip = 0.0001;
  group.root_colour = {0.05f, 0.035f, 0.03f}, group.tip_colour = {0.16f, 0.11f, 0.08f};
  groups.push_back(group);
}

/// A lash on the upper lid's edge, `across` from its middle (0) to a corner (-1, 1): first out, then up and outwards.
GuideCurve lash(const Eye& eye, const FurLids& lids, double across, double side, double size) {
  constexpr double lid_radius = 1.07;  // as eye_block.glsl has it; the edge is that of opening() in eye.frag
  const double a = across * lids.opening.x, y = lids.opening.y * (1 - across * across);
  const glm::dmat3 frame(lids.frame);
  const dvec3 out = frame * dvec3(std::sin(a) * std::cos(y), std::sin(y), std::cos(a) * std::cos(y));
  const dvec3 up = frame * dvec3(0.45 * across + 0.25 * side, 1, 0.1);
  const double radius = eye.radius * size, length = radius * (0.60 + 0.20 * side * across);
  const dvec3 root = eye.position + lid_radius * radius * out;
  return {root, root + length * (0.5 * out + 0.10 * up), root + length * (0.85 * out + 0.55 * up)};
}

CurveGroup lashes(const Eye& eye, const Mesh& mesh) {
  const FurLids lids = make_eye(eye, mesh).lids.value_or(FurLids{});
  const double side = eye.position.x > 0 ? 1 : -1;
  CurveGroup group;
  for (const double across : {-0.72, -0.54, -0.36, -0.18, 0.0, 0.18, 0.36, 0.54, 0.72})
    group.curves.push_back(lash(eye, lids, across, side, mesh.size));
  group.fill = 2;
  group.spread = 0.3;
  group.seed = side > 0 ? 1 : 2;
  group.width_root = 0.0007, group.width_tip = 0.0001;
  group.root_colour = {0.014f, 0.011f, 0.010f}, group.tip_colour = {0.03f, 0.022f, 0.018f};
  return group;
}

}  // namespace

std::vector<CurveGroup> creature_curves(const Surface& surface, std::span<const Eye> eyes) {
  std::vector<CurveGroup> groups;
  for (const double side : {1.0, -1.0}) {
    add_whiskers(side, surface, groups);
    add_brow(side, surface, groups);
  }
  for (const Eye& eye : eyes) groups.push_back(lashes(eye, surface.mesh()));
  return groups;
}

}  // namespace pelage
