#include <cmath>

#include "tests/property/groom/reference/groomed.h"

namespace pelage::plain {

namespace {

/// A mirror image or a rotation; it maps positions (`is_position` true) or directions.
struct Image {
  bool mirror = false;
  Plane plane;
  dvec3 axis_point{0}, axis{0};
  double angle = 0;

  dvec3 operator()(dvec3 p, bool is_position) const {
    if (mirror) {
      const dvec3 n = unit(plane.normal), from = is_position ? plane.point : dvec3(0);
      return p - 2 * glm::dot(p - from, n) * n;
    }
    const dvec3 k = unit(axis), from = is_position ? axis_point : dvec3(0), q = p - from;
    return from + q * std::cos(angle) + glm::cross(k, q) * std::sin(angle) + k * glm::dot(k, q) * (1 - std::cos(angle));
  }
};

/// All images including the command's own: first rotations, then each mirror applied to all images before it.
std::vector<std::vector<Image>> chains_of(const Symmetry& symmetry) {
  std::vector<std::vector<Image>> chains{{}};
  for (int step = 1; step < symmetry.count; ++step) {
    Image turn;
    turn.axis_point = symmetry.axis_point, turn.axis = symmetry.axis;
    turn.angle = 2 * 3.14159265358979323846 * step / symmetry.count;
    chains.push_back({turn});
  }
  for (const Plane& plane : symmetry.planes) {
    const std::size_t so_far = chains.size();
    for (std::size_t k = 0; k < so_far; ++k) {
      chains.push_back(chains[k]);
      Image mirror;
      mirror.mirror = true, mirror.plane = plane;
      chains.back().push_back(mirror);
    }
  }
  return chains;
}

/// Maps every position and direction of a tool.
struct Move {
  const Image& image;

  void move_point(dvec3& p) const { p = image(p, true); }
  void direction(dvec3& d) const { d = image(d, false); }

  template <class Tool>
  void operator()(Tool& tool) const {
    if constexpr (requires { tool.stroke; }) {
      if (tool.stroke) {
        for (StrokeSample& sample : tool.stroke->samples)
          move_point(std::get<PositionSample>(sample.position).position);
      }
    }
    if constexpr (requires { tool.source; }) move_point(tool.source), direction(tool.direction);
    if constexpr (requires { tool.point; }) move_point(tool.point);
    if constexpr (requires { tool.turn_degrees; }) tool.turn_degrees *= image.mirror ? -1 : 1;
    if constexpr (requires { tool.keys; }) {
      for (Key& key : tool.keys) {
        move_point(key.position);
        if (key.direction) direction(*key.direction);
      }
    }
    if constexpr (requires { tool.curves; }) {
      for (auto& curve : tool.curves) {
        for (dvec3& p : curve) move_point(p);
      }
    }
    if constexpr (std::is_same_v<Tool, Unify>) {
      if (tool.direction) direction(*tool.direction);
    }
    if constexpr (std::is_same_v<Tool, Trim>) {
      if (auto* plane = std::get_if<TrimPlane>(&tool.shape)) move_point(plane->point), direction(plane->normal);
      if (auto* sphere = std::get_if<TrimSphere>(&tool.shape)) move_point(sphere->centre);
    }
  }
};

}  // namespace

std::vector<Command> images(const Command& command, const Symmetry& symmetry) {
  std::vector<Command> all;
  for (const std::vector<Image>& chain : chains_of(symmetry)) {
    Command image = command;
    for (const Image& step : chain) std::visit(Move{step}, image);
    all.push_back(image);
  }
  return all;
}

}  // namespace pelage::plain
