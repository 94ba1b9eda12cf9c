// Defines the creature's volumes, from the trunk outwards, its colours and its fur lengths.
#include "server/builtin/creature.h"

#include <algorithm>
#include <cmath>

namespace pelage {
namespace {

using glm::dvec3;

constexpr dvec3 kX{1, 0, 0}, kY{0, 1, 0};

struct Joint {
  dvec3 at;
  double radius;
};

using Cones = std::vector<RoundCone>;

Cones ball(dvec3 centre, double radius, dvec3 flat_axis = kX, double flatten = 1) {
  return {{centre, centre, radius, radius, flat_axis, flatten}};
}

Cones cone(Joint a, Joint b, dvec3 flat_axis = kX, double flatten = 1) {
  return {{a.at, b.at, a.radius, b.radius, flat_axis, flatten}};
}

/// Returns a joint between joints[i] (t = 0) and the next (t = 1) on a Catmull-Rom spline whose ends are repeated.
Joint on_spline(const std::vector<Joint>& joints, std::size_t i, double t) {
  const std::size_t last = joints.size() - 1;
  const Joint &p = joints[i == 0 ? 0 : i - 1], &q = joints[i], &r = joints[i + 1], &s = joints[std::min(i + 2, last)];
  const auto blend = [t](auto a, auto b, auto c, auto d) {
    return b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)));
  };
  return {blend(p.at, q.at, r.at, s.at), blend(p.radius, q.radius, r.radius, s.radius)};
}

/// Returns a limb that passes smoothly through the joints.
Cones chain(const std::vector<Joint>& joints) {
  constexpr int kSegments = 6;
  Cones cones;
  Joint from = joints.front();
  for (std::size_t i = 0; i + 1 < joints.size(); ++i)
    for (int k = 1; k <= kSegments; ++k) {
      const Joint to = on_spline(joints, i, static_cast<double>(k) / kSegments);
      cones.push_back({from.at, to.at, from.radius, to.radius, kX, 1});
      from = to;
    }
  return cones;
}

class Sculpture {
 public:
  void add(const Cones& cones, double width) { volumes_.push_back({cones, width, Blend::add}); }
  void carve(const Cones& cones, double width) { volumes_.push_back({cones, width, Blend::carve}); }

  void add_pair(const Cones& cones, double width) {
    add(cones, width);
    add(mirrored(cones), width);
  }
  void carve_pair(const Cones& cones, double width) {
    carve(cones, width);
    carve(mirrored(cones), width);
  }

  std::vector<Volume> volumes() && { return std::move(volumes_); }

 private:
  static Cones mirrored(Cones cones) {
    for (RoundCone& cone : cones)
      for (dvec3* v : {&cone.a, &cone.b, &cone.flat_axis}) v->x = -v->x;
    return cones;
  }

  std::vector<Volume> volumes_;
};

void add_trunk(Sculpture& s) {
  s.add(chain({{{0, .475, .19}, .165}, {{0, .50, .04}, .156}, {{0, .522, -.10}, .143}, {{0, .495, -.25}, .142}}), .05);
  s.add(cone({{0, .575, .24}, .132}, {{0, .47, .272}, .118}), .08);  // ruff
  s.add(cone({{0, .56, .19}, .13}, {{0, .72, .29}, .112}), .09);     // neck
}

/// Adds four toes in front of a paw.
void add_toes(Sculpture& s, dvec3 paw) {
  for (const dvec3& toe : {dvec3{-.019, -.012, .047}, dvec3{.021, -.012, .047}})
    s.add_pair(cone({paw + 0.5 * toe, .024}, {paw + toe, .0265}), .012);
  for (const dvec3& toe : {dvec3{-.047, -.014, .022}, dvec3{.049, -.014, .022}})
    s.add_pair(cone({paw + 0.5 * toe, .022}, {paw + toe, .024}), .012);
}

void add_forelegs(Sculpture& s) {
  s.add_pair(cone({{.09, .47, .18}, .10}, {{.108, .36, .17}, .078}, kX, 1.2), .06);  // shoulder
  s.add_pair(
      chain(
          {{{.108, .38, .165}, .072}, {{.112, .26, .162}, .061}, {{.112, .15, .168}, .052}, {{.112, .07, .182}, .050}}),
      .05);
  s.add_pair(cone({creature::kForepaw - dvec3(0, -.004, .035), .053}, {creature::kForepaw, .055}, kY, 1.2), .03);
  add_toes(s, creature::kForepaw);
}

void add_hind_legs(Sculpture& s) {
  s.add_pair(cone({{.082, .445, -.215}, .125}, {{.108, .33, -.165}, .092}, kX, 1.3), .06);  // haunch
  s.add_pair(chain({{{.112, .335, -.165}, .082},
                    {{.116, .24, -.205}, .064},
                    {{.118, .155, -.262}, .047},
                    {{.118, .07, -.238}, .047}}),
             .05);
  s.add_pair(cone({creature::kHindPaw - dvec3(0, -.004, .04), .053}, {creature::kHindPaw, .055}, kY, 1.2), .03);
  add_toes(s, creature::kHindPaw);
}

void add_head(Sculpture& s) {
  s.add(ball(creature::kHead, .188, kY, 1.1), .055);
  s.add_pair(cone({{.09, .80, .42}, .095}, {{.155, .785, .385}, .058}), .07);  // cheeks
  s.add(cone({{0, .81, .48}, .095}, {{0, .787, .60}, .056}), .06);             // muzzle
  s.add(cone({{0, .745, .46}, .066}, {{0, .742, .575}, .033}), .018);          // jaw
  s.add_pair(ball({.028, .772, .603}, .038), .025);                            // lips
  s.add_pair(cone({{.045, .915, .49}, .045}, {{.10, .925, .465}, .04}), .06);  // brows
  s.carve_pair(ball(creature::kEye + dvec3(.014, .004, .024), .046), .03);
  s.add(cone({creature::kNose - dvec3(.012, 0, 0), .026}, {creature::kNose + dvec3(.012, 0, 0), .026}, kY, 1.15), .012);
}

/// Adds the ears as thin cups: flattened cones, hollow in front.
void add_ears(Sculpture& s) {
  const dvec3 front = glm::normalize(creature::kEarFront);
  s.add_pair(cone({creature::kEarBase, .105}, {creature::kEarTip, .026}, front, 1.55), .04);
  s.carve_pair(cone({creature::kEarHollowBase, creature::kEarHollowBaseRadius},
                    {creature::kEarHollowTip, creature::kEarHollowTipRadius}),
               .014);
}

void add_tail(Sculpture& s) {
  s.add(chain({{creature::kTailRoot, .056},
               {{0, .470, -.45}, .062},
               {{0, .515, -.575}, .074},
               {{0, .64, -.655}, .083},
               {{0, .79, -.66}, .066},
               {creature::kTailTip, .022}}),
        .05);
}

}  // namespace

std::vector<Volume> creature_volumes() {
  Sculpture s;
  add_trunk(s);
  add_forelegs(s);
  add_hind_legs(s);
  add_head(s);
  add_ears(s);
  add_tail(s);
  return std::move(s).volumes();
}

// The creature's coat as an artist would paint it: a fox's colours, and the fur length of each part.

namespace {

constexpr dvec3 kRed{.42, .16, .05}, kDeepRed{.26, .085, .026}, kCream{.75, .62, .47}, kPale{.66, .47, .34};
constexpr dvec3 kDark{.05, .035, .03}, kBlack{.014, .012, .012};

/// Returns 0 below `low`, 1 above `high`, and a smooth value between.
double rise(double low, double high, double x) { return glm::smoothstep(low, high, x); }
double fall(double low, double high, double x) { return 1 - rise(low, high, x); }

/// Returns 1 inside the ellipsoid around `centre`, 0 outside `outer` times its radii.
double near(dvec3 p, dvec3 centre, dvec3 radii, double outer) {
  return fall(1, outer, glm::length((p - centre) / radii));
}

/// Returns 1 on the head, 0 from the neck down.
double head(dvec3 p) { return rise(.66, .74, p.y + .5 * std::max(0.0, p.z - .42)) * rise(.02, .12, p.z); }

/// Returns the coordinate along the ear: 0 at its base, 1 at the tip.
double along_ear(dvec3 p) {
  const dvec3 axis = creature::kEarTip - creature::kEarBase;
  return glm::dot(p - creature::kEarBase, axis) / glm::dot(axis, axis);
}

/// Returns 1 in the ear's hollow, 0 on its back.
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

/// Returns the colour of the body. `p` must be on the +X side.
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
