#include "server/scene/creature_settings.h"

#include <cmath>

#include "server/builtin/creature.h"
#include "server/scene/eye_view.h"

namespace pelage {

namespace {

using glm::dvec3;

/// A long hair in model coordinates, on the +X side of the head.
struct Hair {
  dvec3 root;       // near the skin
  dvec3 direction;  // direction at the root, of any length but 0
  double length;
  dvec3 bends;  // offset of the tip from that of a straight hair, in lengths of the hair
};

/// Returns the hair as a curve rooted in the skin. `side` is 1, or -1 for its mirror image.
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

/// Adds the eight whiskers of one side: an upper and a lower row of four, the longest behind. Two of each row are
/// guides and two are interpolated.
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

/// Returns a lash on the edge of the upper lid; it grows first outwards, then up and sideways. `across` is its
/// position, from -1 at one corner of the eye over 0 in the middle to 1 at the other.
GuideCurve lash(const Eye& eye, const FurLids& lids, double across, double side, double size) {
  constexpr double lid_radius = 1.07;  // as in renderer/optics/iris-inl.h; the edge follows lid_opening() there
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

namespace {

constexpr glm::vec3 black{0.016f, 0.014f, 0.014f}, hole{0.003f, 0.002f, 0.002f}, pad_grey{0.10f, 0.068f, 0.062f};
constexpr glm::vec3 pink{0.44f, 0.22f, 0.175f}, deep_red{0.27f, 0.10f, 0.078f};

/// Makes a region from `centre` and `radii` in the model's unit; one of a pair is given on the +X side.
SkinRegion region(glm::dvec3 centre, glm::dvec3 radii, const Mesh& mesh) {
  return {.centre = centre, .radii = radii / mesh.size};
}

SkinRegion nose(const Mesh& mesh) {
  SkinRegion result = region(creature::kNose + glm::dvec3(0, .004, .010), {.036, .027, .034}, mesh);
  result.softness = 0.35;
  result.colour = black;
  result.shine = 0.6, result.roughness = 0.4, result.wetness = 0.75, result.scatter = 0.3;
  result.bumps = {.height = 0.0003, .size = 0.0019};
  return result;
}

SkinRegion nostril(double side, const Mesh& mesh) {
  SkinRegion result = region(creature::kNose + glm::dvec3(side * .018, -.005, .022), {.0075, .0042, .016}, mesh);
  result.turn_degrees = side * 32;
  result.softness = 0.9;
  result.colour = hole;
  result.shine = 0, result.scatter = 0;
  result.bumps.height = 0;
  return result;
}

/// Returns dark skin from the nose down and along the mouth.
std::vector<SkinRegion> lips(const Mesh& mesh) {
  std::vector<SkinRegion> result;
  SkinRegion cleft = region({0, .770, .655}, {.0035, .026, .03}, mesh);
  SkinRegion mouth = region({.028, .748, .612}, {.034, .006, .045}, mesh);
  mouth.turn_degrees = 14;
  for (SkinRegion* part : {&cleft, &mouth}) {
    part->softness = 0.8;
    part->colour = black;
    part->roughness = 0.4, part->wetness = 0.3, part->scatter = 0.3;
    part->bumps.height = 0;
  }
  result.push_back(cleft);
  for (const double side : {1.0, -1.0}) {
    SkinRegion half = mouth;
    half.centre.x *= side, half.turn_degrees *= side;
    result.push_back(half);
  }
  return result;
}

/// Returns the skin on the floor of the ear's hollow: pink, and red where the ear is deep.
std::vector<SkinRegion> ear(double side, const Mesh& mesh) {
  const glm::dvec3 mirrored(side, 1, 1);
  const auto on_floor = [&](double t) {
    const double radius = glm::mix(creature::kEarHollowBaseRadius, creature::kEarHollowTipRadius, t);
    return (glm::mix(creature::kEarHollowBase, creature::kEarHollowTip, t) - radius * creature::kEarFront) * mirrored;
  };
  SkinRegion hollow = region(on_floor(0.47), {.036, .088, .05}, mesh);
  hollow.axis = creature::kEarFront * mirrored;
  hollow.turn_degrees = side * -28;  // along the ear
  hollow.softness = 0.7;
  hollow.facing = SkinFacing{.direction = creature::kEarFront * mirrored, .angle_degrees = 68, .fade_degrees = 30};
  hollow.colour = pink;
  hollow.shine = 0.3, hollow.roughness = 0.6, hollow.scatter = 1;
  hollow.bumps.height = 0;
  SkinRegion deep = hollow;
  deep.centre = on_floor(0.08);
  deep.radii = glm::dvec3(.010, .024, .03) / mesh.size;
  deep.softness = 5;
  deep.colour = deep_red;
  return {hollow, deep};
}

/// Returns one large pad and four small ones under a paw.
std::vector<SkinRegion> pads(glm::dvec3 paw, double side, const Mesh& mesh) {
  struct Pad {
    glm::dvec3 at, radii;
  };
  const Pad parts[] = {{{0, -.040, -.004}, {.036, .022, .026}},
                       {{-.020, -.034, .053}, {.016, .018, .022}},
                       {{.022, -.034, .053}, {.016, .018, .022}},
                       {{-.051, -.034, .026}, {.015, .018, .020}},
                       {{.053, -.034, .026}, {.015, .018, .020}}};
  std::vector<SkinRegion> result;
  for (const Pad& pad : parts) {
    SkinRegion made = region((paw + pad.at) * glm::dvec3(side, 1, 1), pad.radii, mesh);
    made.softness = 0.5;
    made.colour = pad_grey;
    made.roughness = 0.6, made.scatter = 0.3;
    made.bumps = {.height = 0.0004, .size = 0.0024};
    result.push_back(made);
  }
  return result;
}

}  // namespace

std::vector<SkinRegion> creature_skin(const Mesh& mesh) {
  std::vector<SkinRegion> result = lips(mesh);
  result.push_back(nose(mesh));
  for (const double side : {1.0, -1.0}) {
    result.push_back(nostril(side, mesh));
    const std::vector<SkinRegion> of_ear = ear(side, mesh);
    result.insert(result.end(), of_ear.begin(), of_ear.end());
    for (const glm::dvec3& paw : {creature::kForepaw, creature::kHindPaw}) {
      const std::vector<SkinRegion> of_paw = pads(paw, side, mesh);
      result.insert(result.end(), of_paw.begin(), of_paw.end());
    }
  }
  return result;
}

namespace {

/// Returns a fox's eyes: amber, with slit pupils and dark, slanted lids.
std::vector<Eye> creature_eyes(const Mesh& mesh) {
  std::vector<Eye> eyes;
  for (const double side : {1.0, -1.0}) {
    Eye eye;
    eye.position = creature::kEyeball * glm::dvec3(side, 1, 1);
    eye.radius = creature::kEyeballRadius / mesh.size;
    eye.gaze = {side * 0.30, 0.04, 1};
    eye.pupil.shape = PupilShape::slit;
    eye.iris.turn_degrees = side * 37;
    eye.lids = Lids{.facing = glm::dvec3(side * 0.52, 0.10, 1), .tilt_degrees = side * 14};
    eyes.push_back(eye);
  }
  return eyes;
}

}  // namespace

SceneSettings first_settings(const SceneModel& model, bool ground) {
  SceneSettings settings;
  settings.ground.visible = ground;
  if (model.name != "creature") return settings;
  settings.eyes = creature_eyes(model.surface.mesh());
  settings.curves = creature_curves(model.surface, settings.eyes);
  settings.skin = creature_skin(model.surface.mesh());
  return settings;
}

}  // namespace pelage
