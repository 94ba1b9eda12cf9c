#include "server/scene/creature_skin.h"

#include "server/builtin/creature.h"

namespace pelage {

namespace {

constexpr glm::vec3 black{0.016f, 0.014f, 0.014f}, hole{0.003f, 0.002f, 0.002f}, pad_grey{0.10f, 0.068f, 0.062f};
constexpr glm::vec3 pink{0.44f, 0.22f, 0.175f}, deep_red{0.27f, 0.10f, 0.078f};

/// `centre` and `radii` in the model's own units, on the +X side where it is one of a pair.
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

/// Dark skin from the nose down and along the mouth.
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

/// On the hollow's floor: pink, and red where the ear is deep.
std::vector<SkinRegion> ear(double side, const Mesh& mesh) {
  const glm::dvec3 mirrored(side, 1, 1);
  const auto on_floor = [&](double t) {
    const double radius = glm::mix(creature::kEarHollowBaseRadius, creature::kEarHollowTipRadius, t);
    return (glm::mix(creature::kEarHollowBase, creature::kEarHollowTip, t) - radius * creature::kEarFront) * mirrored;
  };
  SkinRegion whole = region(on_floor(0.47), {.036, .088, .05}, mesh);
  whole.axis = creature::kEarFront * mirrored;
  whole.turn_degrees = side * -28;  // along the ear
  whole.softness = 0.7;
  whole.facing = SkinFacing{.direction = creature::kEarFront * mirrored, .angle_degrees = 68, .fade_degrees = 30};
  whole.colour = pink;
  whole.shine = 0.3, whole.roughness = 0.6, whole.scatter = 1;
  whole.bumps.height = 0;
  SkinRegion deep = whole;
  deep.centre = on_floor(0.08);
  deep.radii = glm::dvec3(.010, .024, .03) / mesh.size;
  deep.softness = 5;
  deep.colour = deep_red;
  return {whole, deep};
}

/// One large pad and four small ones under a paw.
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

}  // namespace pelage
