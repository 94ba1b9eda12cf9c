#include "server/scene/creature_skin.h"

#include "server/surface/creature.h"

namespace pelage {

namespace {

constexpr glm::vec3 black{0.016f, 0.014f, 0.014f}, pad_grey{0.045f, 0.034f, 0.032f}, pink{0.52f, 0.25f, 0.20f};

/// `centre` and `radii` in the model's own units, on the +X side where it is one of a pair.
SkinRegion region(glm::dvec3 centre, glm::dvec3 radii, const Mesh& mesh) {
  return {.centre = centre, .radii = radii / mesh.size};
}

SkinRegion nose(const Mesh& mesh) {
  SkinRegion result = region(creature::kNose + glm::dvec3(0, .004, .010), {.036, .027, .034}, mesh);
  result.softness = 0.35;
  result.colour = black;
  result.shine = 0.6, result.roughness = 0.4, result.wetness = 0.75, result.scatter = 0.3;
  result.bumps = {.height = 0.0005, .size = 0.0024};
  return result;
}

/// Dark skin from the nose down and along the mouth.
std::vector<SkinRegion> lips(const Mesh& mesh) {
  std::vector<SkinRegion> result;
  SkinRegion cleft = region({0, .770, .655}, {.0035, .026, .03}, mesh);
  SkinRegion mouth = region({.028, .748, .612}, {.034, .0045, .045}, mesh);
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

SkinRegion ear(double side, const Mesh& mesh) {
  const glm::dvec3 mirrored(side, 1, 1);
  const glm::dvec3 middle = glm::mix(creature::kEarHollowBase, creature::kEarHollowTip, 0.40);
  SkinRegion result = region(middle * mirrored, {.052, .062, .105}, mesh);
  result.axis = (creature::kEarHollowTip - creature::kEarHollowBase) * mirrored;
  result.softness = 0.5;
  result.facing = SkinFacing{.direction = creature::kEarFront * mirrored, .angle_degrees = 62, .fade_degrees = 25};
  result.colour = pink;
  result.shine = 0.35, result.roughness = 0.6, result.scatter = 1;
  result.bumps = {.height = 0.0001, .size = 0.003};
  return result;
}

/// One large pad and four small ones under a paw.
std::vector<SkinRegion> pads(glm::dvec3 paw, double side, const Mesh& mesh) {
  struct Pad {
    glm::dvec3 at, radii;
  };
  const Pad parts[] = {{{0, -.036, .004}, {.026, .020, .022}},
                       {{-.019, -.030, .054}, {.013, .014, .019}},
                       {{.021, -.030, .054}, {.013, .014, .019}},
                       {{-.049, -.030, .027}, {.012, .014, .018}},
                       {{.051, -.030, .027}, {.012, .014, .018}}};
  std::vector<SkinRegion> result;
  for (const Pad& pad : parts) {
    SkinRegion made = region((paw + pad.at) * glm::dvec3(side, 1, 1), pad.radii, mesh);
    made.softness = 0.5;
    made.colour = pad_grey;
    made.roughness = 0.6, made.scatter = 0.3;
    made.bumps = {.height = 0.0005, .size = 0.003};
    result.push_back(made);
  }
  return result;
}

}  // namespace

std::vector<SkinRegion> creature_skin(const Mesh& mesh) {
  std::vector<SkinRegion> result = lips(mesh);
  result.push_back(nose(mesh));
  for (const double side : {1.0, -1.0}) {
    result.push_back(ear(side, mesh));
    for (const glm::dvec3& paw : {creature::kForepaw, creature::kHindPaw}) {
      const std::vector<SkinRegion> of_paw = pads(paw, side, mesh);
      result.insert(result.end(), of_paw.begin(), of_paw.end());
    }
  }
  return result;
}

}  // namespace pelage
