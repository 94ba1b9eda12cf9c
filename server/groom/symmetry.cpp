#include <glm/gtc/matrix_transform.hpp>

#include "server/groom/brush.h"
#include "server/groom/evaluate.h"
#include "server/groom/vertex_frame.h"

namespace pelage {

namespace {

/// A rigid motion or a mirror image of the model's space.
struct Motion {
  glm::dmat3 turn{1};
  glm::dvec3 shift{0};

  glm::dvec3 place(glm::dvec3 p) const { return turn * p + shift; }
  glm::dvec3 direction(glm::dvec3 d) const { return turn * d; }
};

Motion after(const Motion& first, const Motion& second) {
  return {second.turn * first.turn, second.turn * first.shift + second.shift};
}

Motion mirror(const Plane& plane) {
  const glm::dvec3 n = safe_unit(plane.normal);
  return {glm::dmat3(1) - 2.0 * glm::outerProduct(n, n), 2 * glm::dot(plane.point, n) * n};
}

Motion rotation(const Symmetry& symmetry, int step) {
  const double angle = glm::radians(360.0 * step / symmetry.count);
  const glm::dmat3 turn(glm::rotate(glm::dmat4(1), angle, safe_unit(symmetry.axis)));
  return {turn, symmetry.axis_point - turn * symmetry.axis_point};
}

/// Every motion of the symmetry but the one that moves nothing.
std::vector<Motion> motions_of(const Symmetry& symmetry) {
  std::vector<Motion> all{Motion{}};
  for (int step = 1; step < symmetry.count; ++step) all.push_back(rotation(symmetry, step));
  for (const Plane& plane : symmetry.planes) {
    const std::size_t before = all.size();
    for (std::size_t k = 0; k < before; ++k) all.push_back(after(all[k], mirror(plane)));
  }
  all.erase(all.begin());
  return all;
}

/// Moves the places and directions of a command.
class Mover {
 public:
  Mover(const Motion& motion, const Surface& surface) : motion_(motion), surface_(surface) {}

  template <class Tool>
  bool operator()(Tool& tool) const {
    bool moved = false;
    if constexpr (requires { tool.stroke; }) {
      if (tool.stroke) {
        without_view(tool.brush, *tool.stroke);
        move(*tool.stroke), moved = true;
      }
    }
    return move_parts(tool) || moved;
  }

 private:
  void move(glm::dvec3& place) const { place = motion_.place(place); }
  void turn(glm::dvec3& direction) const { direction = motion_.direction(direction); }

  /// Views are of what was drawn, so an image has none: it judges its front faces by the skin, and its radius is that
  /// of the first sample.
  void without_view(Brush& brush, const Stroke& stroke) const {
    if (!stroke.view) return;
    brush.radius = BrushStroke(stroke, brush, surface_).radius(), brush.units = RadiusUnits::relative;
    if (brush.falloff_shape == FalloffShape::screen) brush.falloff_shape = FalloffShape::volume;
  }
  void move(Stroke& stroke) const {
    for (StrokeSample& sample : stroke.samples) {
      if (auto* place = std::get_if<PositionPlace>(&sample.place)) move(place->position);
      if (auto* place = std::get_if<SurfacePlace>(&sample.place)) *place = moved(*place);
    }
    stroke.view.reset();
  }
  SurfacePlace moved(const SurfacePlace& place) const {
    const Mesh& mesh = surface_.mesh();
    const glm::dvec3 position = mesh.to_model(surface_.position({place.triangle, place.barycentric}));
    const SurfacePoint there = surface_.nearest(mesh.to_internal(motion_.place(position)));
    return {there.triangle, glm::max(there.barycentric, 0.0)};
  }

  bool move_parts(Comb& comb) const {
    if (comb.direction) turn(*comb.direction);
    return comb.direction.has_value();
  }
  bool move_parts(Blow& blow) const { return move(blow.source), turn(blow.direction), true; }
  bool move_parts(Attract& attract) const { return move(attract.point), true; }
  bool move_parts(Interpolate& command) const {
    for (Key& key : command.keys) {
      move(key.position);
      if (key.direction) turn(*key.direction);
    }
    return true;
  }
  bool move_parts(Flow& command) const {
    for (std::vector<glm::dvec3>& curve : command.curves) {
      for (glm::dvec3& point : curve) move(point);
    }
    return true;
  }
  bool move_parts(Unify& unify) const {
    if (unify.direction) turn(*unify.direction);
    return false;
  }
  bool move_parts(Trim& trim) const {
    if (auto* plane = std::get_if<TrimPlane>(&trim.shape)) move(plane->point), turn(plane->normal);
    if (auto* sphere = std::get_if<TrimSphere>(&trim.shape)) move(sphere->centre);
    return false;
  }
  bool move_parts(Curl& curl) const {
    if (glm::determinant(motion_.turn) < 0) curl.turn_degrees = -curl.turn_degrees;
    return false;
  }
  template <class Tool>
  bool move_parts(Tool&) const {
    return false;
  }

  const Motion& motion_;
  const Surface& surface_;
};

/// Keys and curves of all images together say what a body is like; one after the other they would overwrite it.
bool joins_images(Command& whole, const Command& image) {
  if (auto* keys = std::get_if<Interpolate>(&whole); keys && !keys->stroke) {
    const auto& more = std::get<Interpolate>(image).keys;
    keys->keys.insert(keys->keys.end(), more.begin(), more.end());
    return true;
  }
  if (auto* flow = std::get_if<Flow>(&whole); flow && !flow->stroke) {
    const auto& more = std::get<Flow>(image).curves;
    flow->curves.insert(flow->curves.end(), more.begin(), more.end());
    return true;
  }
  return false;
}

bool is_flood(const Command& command) {
  return std::visit(
      [](const auto& tool) {
        if constexpr (requires { tool.flood; })
          return tool.flood;
        else
          return false;
      },
      command);
}

}  // namespace

std::vector<Command> images_of(const Command& resolved, const Symmetry& symmetry, const Surface& surface) {
  std::vector<Command> images{resolved};
  if (is_flood(resolved)) return images;
  for (const Motion& motion : motions_of(symmetry)) {
    Command image = resolved;
    if (!std::visit(Mover(motion, surface), image)) break;  // no place that could be moved
    if (!joins_images(images.front(), image)) images.push_back(std::move(image));
  }
  return images;
}

}  // namespace pelage
