// The creature's coat as an artist would paint it: a fox's colours, and how long each part's fur is.
#include <algorithm>
#include <cmath>

#include "server/builtin/creature.h"

namespace pelage {
namespace {

using glm::dvec3;

constexpr dvec3 kRed{.42, .16, .05}, kDeepRed{.26, .085, .026}, kCream{.75, .62, .47}, kPale{.66, .47, .34};
constexpr dvec3 kDark{.05, .035, .03}, kBlack{.014, .012, .012};

/// 0 below `low`, 1 above `high`, smooth between.
double rise(double low, double high, double x) { return glm::smoothstep(low, high, x); }
double fall(double low, double high, double x) { return 1 - rise(low, high, x); }

/// 1 inside the ellipsoid around `centre`, 0 outside `outer` times its radii.
double near(dvec3 p, dvec3 centre, dvec3 radii, double outer) {
  return fall(1, outer, glm::length((p - centre) / radii));
}

/// 1 on the head, 0 from the neck down.
double head(dvec3 p) { return rise(.66, .74, p.y + .5 * std::max(0.0, p.z - .42)) * rise(.02, .12, p.z); }

/// How far out along the ear: 0 at its base, 1 at the tip.
double along_ear(dvec3 p) {
  const dvec3 axis = creature::kEarTip - creature::kEarBase;
  return glm::dot(p - creature::kEarBase, axis) / glm::dot(axis, axis);
}

/// 1 in the ear's hollow, 0 on its back.
double in_ear(dvec3 p) {
  const dvec3 axis = creature::kEarHollowTip - creature::kEarHollowBase;
  const double t = std::clamp(glm::dot(p - creature::kEarHollowBase, axis) / glm::dot(axis, axis), 0.0, 1.0);
  const double radius = glm::mix(creature::kEarHollowBaseRadius, creature::kEarHollowTipRadius, t);
  return fall(0, .018, glm::distance(p, creature::kEarHollowBase + t * axis) - radius);
}

double belly(dvec3 p) { return fall(.38, .47, p.y + .55 * p.x) * fall(.085, .13, p.x); }
double bib(dvec3 p) { return near(p, {0, .53, .41}, {.06, .19, .09}, 2.3); }
double on_tail(dvec3 p) { return rise(.36, .47, -p.z) * rise(.36, .42, p.y); }
double cheek(dvec3 p) { return fall(.772, .822, p.y - .5 * std::max(0.0, p.x - .07)) * rise(.30, .42, p.z) * head(p); }
double ear_region(dvec3 p) { return rise(.97, 1.03, p.y); }

/// `p` on the +X side.
dvec3 body_colour(dvec3 p) {
  dvec3 c = glm::mix(kRed, kDeepRed, .75 * fall(.02, .09, p.x) * rise(.55, .64, p.y) * (1 - head(p)));
  c = glm::mix(c, kCream, std::max(belly(p), bib(p)));
  const double from_tip = glm::distance(p, creature::kTailTip);
  c = glm::mix(c, kDeepRed, .7 * on_tail(p) * fall(.24, .42, from_tip));
  c = glm::mix(c, kCream, fall(.15, .24, from_tip));
  return glm::mix(c, kDark, fall(.12, .25, p.y + .15 * (p.x - .11)));
}

dvec3 face_colour(dvec3 c, dvec3 p) {
  c = glm::mix(c, kCream, cheek(p));
  c = glm::mix(c, kCream, .55 * near(p, creature::kEye + dvec3(-.014, .068, -.01), {.018, .012, .05}, 2.4));
  c = glm::mix(c, kDark, .8 * near(p, creature::kEye, {.036, .032, .05}, 1.7));
  c = glm::mix(c, kBlack, near(p, creature::kEye, {.022, .021, .05}, 1.4));
  const dvec3 tear = creature::kEye + dvec3(-.036, -.036, .03);
  c = glm::mix(c, kDark, .6 * near(p, tear, {.010, .020, .04}, 2.2));
  return glm::mix(c, kBlack, near(p, creature::kNose, {.04, .03, .034}, 1.35));
}

dvec3 ear_colour(dvec3 c, dvec3 p) {
  const double out = along_ear(p);
  c = glm::mix(c, kDark, rise(.25, .75, out) * ear_region(p));
  return glm::mix(c, kPale, in_ear(p) * rise(.93, .99, p.y) * fall(.82, 1.02, out));
}

double body_length(dvec3 p) {
  double s = 1;
  s = glm::mix(s, 1.4, near(p, {0, .56, .30}, {.16, .14, .18}, 1.6));
  s = glm::mix(s, 1.8, on_tail(p));
  return glm::mix(s, .4, fall(.19, .36, p.y + .6 * std::max(0.0, .07 - p.x)));
}

double head_length(double s, dvec3 p) {
  s = glm::mix(s, .6, head(p));
  s = glm::mix(s, .35, head(p) * rise(.36, .50, p.z));
  s = glm::mix(s, 1.15, near(p, {.185, .775, .35}, {.05, .06, .09}, 1.9));
  s = glm::mix(s, .5, ear_region(p));
  s = glm::mix(s, .1, near(p, creature::kEye, {.045, .040, .06}, 1.7));
  return glm::mix(s, .1, near(p, creature::kNose, {.042, .034, .036}, 1.8));
}

}  // namespace

CreatureLook creature_look(glm::dvec3 position) {
  const dvec3 p{std::abs(position.x), position.y, position.z};
  return {ear_colour(face_colour(body_colour(p), p), p), head_length(body_length(p), p)};
}

}  // namespace pelage
