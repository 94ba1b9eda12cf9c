// Tools that turn fur under a brush.
#include <algorithm>
#include <cmath>

#include "tests/property/groom/reference/brush.h"
#include "tests/property/groom/reference/tools.h"

namespace pelage::plain {

namespace {

constexpr double turning_pi = 3.14159265358979323846;

void set_direction(Fur& fur, Vertex v, dvec2 direction) { fur.of(Field::direction)[v] = dvec4(direction, 0, 0); }

/// Returns the same heading with another inclination.
dvec2 with_length(dvec2 direction, double length) {
  const double now = glm::length(direction);
  return now > 1e-6 ? direction * (length / now) : direction;
}

void comb_vertex(const Comb& command, const Body& body, Fur& fur, Vertex v, dvec3 towards, double w) {
  const dvec2 before = fur.direction(v);
  const double own = glm::length(before);
  dvec2 after = turned_to(body, v, before, towards, command.keep_inclination ? own : command.lean, w);
  if (command.keep_inclination) after = with_length(after, own);
  set_direction(fur, v, after);
}

/// Returns 1 inside the cone, with a smoothstep down over its soft share.
double in_cone(const Blow& blow, dvec3 axis, dvec3 heading) {
  const double angle = 2 * std::atan2(glm::length(axis - heading), glm::length(axis + heading)) * 180 / turning_pi;
  const double soft = blow.cone_degrees * blow.softness;
  if (angle >= blow.cone_degrees) return angle == 0 || (soft == 0 && angle == blow.cone_degrees) ? 1 : 0;
  if (angle <= blow.cone_degrees - soft) return 1;
  const double t = (blow.cone_degrees - angle) / soft;
  return 3 * t * t - 2 * t * t * t;
}

/// Changes stretch and length by the part of the pull along the tip.
void pull_out(const Attract& command, Fur& fur, Vertex v, double added) {
  const double stretch = fur.number(Field::stretch, v);
  const auto grown = [&](double s) { return std::min(command.max_stretch, 1 + std::max(0.0, s - command.threshold)); };
  fur.of(Field::length)[v].x *= grown(stretch + added) / grown(stretch);
  fur.of(Field::stretch)[v].x = stretch + added;
}

void attract_vertex(const Attract& command, const Body& body, Fur& fur, Vertex v, dvec3 pull, double w) {
  const dvec2 before = fur.direction(v);
  const double lean = glm::length(before) * turning_pi / 2;
  const dvec3 sideways = unit(body.in_space(v, before));
  const dvec3 tip = std::cos(lean) * body.normals[v] + std::sin(lean) * sideways;
  const double share = 1 - std::pow(1 - w, command.duration);
  const dvec2 across = body.in_frame(v, pull);
  const double up = glm::dot(pull, body.normals[v]);
  const double goal = std::min(1.0, std::atan2(glm::length(across), up) / (turning_pi / 2));
  if (glm::length(across) >= 1e-6)
    set_direction(fur, v, turned_to(body, v, before, pull, goal, share));
  else if (up > 0)
    set_direction(fur, v, before * (1 - share));
  pull_out(command, fur, v, w * command.duration * std::max(0.0, glm::dot(pull, tip)));
}

}  // namespace

void apply(const Comb& command, const Stage& stage, Fur& fur) {
  const Body& body = stage.body;
  const double sign = command.brush.invert ? -1 : 1;
  if (command.flood) {
    for (Vertex v = 0; v < body.size(); ++v)
      comb_vertex(command, body, fur, v, sign * unit(*command.direction),
                  command.brush.strength * fur.number(Field::mask, v));
    return;
  }
  const std::optional<Standing> standing = standing_of(command.brush, stage, fur);
  for (const Print& print : prints_of(*command.stroke, command.brush, body, false)) {
    const std::vector<double> weights = weights_of(print, *command.stroke, command.brush, body, standing);
    for (Vertex v = 0; v < body.size(); ++v) {
      const double w = 1 - std::pow(1 - weights[v] * fur.number(Field::mask, v), print.arc);
      comb_vertex(command, body, fur, v, sign * print.motion, w);
    }
  }
}

void apply(const Blow& command, const Stage& stage, Fur& fur) {
  const Body& body = stage.body;
  const dvec3 source = body.inside(command.source), axis = unit(command.direction);
  const double fall = body.sizes(command.fall, command.units);
  const std::vector<double> region = restriction_of(command.stroke, command.brush, stage, fur);
  for (Vertex v = 0; v < body.size(); ++v) {
    const dvec3 wind = unit(body.positions[v] - source);
    const double away = glm::distance(body.positions[v], source);
    const double fallen = fall > 0 ? 1 / (1 + (away / fall) * (away / fall)) : 1;
    const double w = command.strength * region[v] * in_cone(command, axis, wind) * fallen;
    set_direction(fur, v, turned_to(body, v, fur.direction(v), command.brush.invert ? -wind : wind, command.lean, w));
  }
}

void apply(const Attract& command, const Stage& stage, Fur& fur) {
  const Body& body = stage.body;
  const dvec3 point = body.inside(command.point);
  const double radius = body.sizes(command.radius, command.units);
  if (radius == 0) return;
  const std::vector<double> region = restriction_of(command.stroke, command.brush, stage, fur);
  for (Vertex v = 0; v < body.size(); ++v) {
    const dvec3 pull = unit(point - body.positions[v]) * (command.brush.invert ? -1.0 : 1.0);
    const double near = glm::distance(point, body.positions[v]) / radius;
    const double w = command.strength * region[v] * falloff_at(command.brush, near);
    if (w > 0) attract_vertex(command, body, fur, v, pull, w);
  }
}

void apply(const Part& command, const Stage& stage, Fur& fur) {
  if (command.stroke->samples.empty()) return;
  const std::vector<double> region = region_of(command.stroke, command.brush, stage, fur);
  for (Vertex v = 0; v < stage.body.size(); ++v) {
    const dvec3 position = stage.body.positions[v];
    dvec3 away = unit(position - nearest_of_path(*command.stroke, stage.body, position));
    if (command.brush.invert) away = -away;
    set_direction(fur, v, turned_to(stage.body, v, fur.direction(v), away, command.lean, region[v]));
  }
}

void apply(const Whorl& command, const Stage& stage, Fur& fur) {
  if (command.stroke->samples.empty()) return;
  const Body& body = stage.body;
  const std::vector<double> region = region_of(command.stroke, command.brush, stage, fur);
  for (Vertex v = 0; v < body.size(); ++v) {
    const dvec2 out =
        body.in_frame(v, unit(body.positions[v] - nearest_of_path(*command.stroke, body, body.positions[v])));
    if (glm::length(out) < 1e-6) continue;
    const double heading =
        std::atan2(out.y, out.x) + command.turn_degrees * turning_pi / 180 * (command.brush.invert ? -1 : 1);
    const dvec2 goal = command.lean * dvec2(std::cos(heading), std::sin(heading));
    set_direction(fur, v, (1 - region[v]) * fur.direction(v) + region[v] * goal);
  }
}

void apply(const Lift& command, const Stage& stage, Fur& fur) {
  const std::vector<double> region = region_of(command.stroke, command.brush, stage, fur);
  for (Vertex v = 0; v < stage.body.size(); ++v) {
    const double now = glm::length(fur.direction(v));
    const double goal = command.brush.invert ? 1 : 0;
    set_direction(fur, v, with_length(fur.direction(v), (1 - region[v]) * now + region[v] * goal));
  }
}

void apply(const Clump& command, const Stage& stage, Fur& fur) {
  if (command.stroke->samples.empty()) return;
  const std::vector<double> region = region_of(command.stroke, command.brush, stage, fur);
  for (Vertex v = 0; v < stage.body.size(); ++v) {
    const dvec3 position = stage.body.positions[v];
    dvec3 middle = unit(nearest_of_path(*command.stroke, stage.body, position) - position);
    if (command.brush.invert) middle = -middle;
    const double lean = std::max(0.5, glm::length(fur.direction(v)));
    set_direction(fur, v, turned_to(stage.body, v, fur.direction(v), middle, lean, command.gather * region[v]));
    double& clump = fur.of(Field::clump)[v].x;
    clump = (1 - region[v]) * clump + (command.brush.invert ? 0 : region[v] * command.amount);
  }
}

void apply(const Curl& command, const Stage& stage, Fur& fur) {
  const std::vector<double> region = region_of(command.stroke, command.brush, stage, fur);
  for (Vertex v = 0; v < stage.body.size(); ++v) {
    const dvec2 d = fur.direction(v);
    const double turn = command.turn_degrees * turning_pi / 180 * region[v] * (command.brush.invert ? -1 : 1);
    const double heading = std::atan2(d.y, d.x) + turn;  // seen from outside, tangent to bitangent is counter-clockwise
    set_direction(fur, v, glm::length(d) * dvec2(std::cos(heading), std::sin(heading)));
    double& curl = fur.of(Field::curl)[v].x;
    curl = (1 - region[v]) * curl + (command.brush.invert ? 0 : region[v] * command.amount);
  }
}

}  // namespace pelage::plain
