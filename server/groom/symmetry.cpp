#include "server/groom/symmetry.h"

#include <glm/gtc/matrix_transform.hpp>

#include "server/groom/brush.h"
#include "server/groom/evaluate.h"
#include "server/groom/vertex_frame.h"

namespace pelage {

namespace {

class Mover {
 public:
  Mover(const PositionMap& map, const Surface& surface) : map_(map), surface_(surface) {}

  template <class Tool>
  bool operator()(Tool& tool) const {
    bool moved = false;
    if constexpr (requires { tool.stroke; }) {
      if (tool.stroke) {
        without_view(tool.brush, *tool.stroke);
        move(*tool.stroke), moved = true;
      }
      if (tool.brush.units == RadiusUnits::world) tool.brush.radius = map_.length(tool.brush.radius);
      if (tool.brush.symmetry) move(*tool.brush.symmetry);
    }
    if constexpr (requires { tool.turn_degrees; }) {
      if (map_.mirrors()) tool.turn_degrees = -tool.turn_degrees;
    }
    return move_parts(tool) || moved;
  }

 private:
  void move(glm::dvec3& position) const { position = map_.mapped(position); }
  void move_on_skin(glm::dvec3& position) const { position = map_.on_skin(position); }
  void move(Symmetry& symmetry) const {
    for (Plane& plane : symmetry.planes) move(plane.point), plane.normal = map_.normal(plane.normal);
    move(symmetry.axis_point), turn(symmetry.axis);
  }
  /// Moves a curve in space; its root stays on the skin.
  void move_curve(GuideCurve& curve) const {
    const glm::dvec3 root = map_.on_skin(curve.front()), shift = root - map_.mapped(curve.front());
    for (glm::dvec3& point : curve) point = map_.mapped(point) + shift;
    curve.front() = root;
  }
  void turn(glm::dvec3& direction) const { direction = map_.direction(direction); }
  void scale(double& length, Units units) const {
    if (units == Units::world) length = map_.length(length);
  }
  void scale(std::optional<double>& length, Units units) const {
    if (length) scale(*length, units);
  }

  void without_view(Brush& brush, const Stroke& stroke) const {
    if (!stroke.view) return;
    brush.radius = BrushStroke(stroke, brush, surface_).radius(), brush.units = RadiusUnits::relative;
    if (brush.falloff_shape == FalloffShape::screen) brush.falloff_shape = FalloffShape::volume;
  }
  void move(Stroke& stroke) const {
    for (StrokeSample& sample : stroke.samples) {
      if (auto* in_space = std::get_if<PositionSample>(&sample.position)) move_on_skin(in_space->position);
      if (auto* on_skin = std::get_if<SurfaceSample>(&sample.position)) *on_skin = map_.on_skin(*on_skin);
    }
    stroke.view.reset();
  }

  bool move_parts(Comb& comb) const {
    if (comb.direction) turn(*comb.direction);
    return comb.direction.has_value();
  }
  bool move_parts(Blow& blow) const {
    scale(blow.fall, blow.units);
    return move(blow.source), turn(blow.direction), true;
  }
  bool move_parts(Attract& attract) const {
    scale(attract.radius, attract.units);
    return move_on_skin(attract.point), true;
  }
  bool move_parts(Interpolate& command) const {
    for (Key& key : command.keys) {
      move_on_skin(key.position);
      if (key.direction) turn(*key.direction);
      scale(key.length, command.units);
    }
    scale(command.sigma, command.units), scale(command.reach, command.units);
    return true;
  }
  bool move_parts(Flow& command) const {
    for (std::vector<glm::dvec3>& curve : command.curves) {
      for (glm::dvec3& point : curve) move_on_skin(point);
    }
    scale(command.sigma, command.units), scale(command.reach, command.units);
    return true;
  }
  bool move_parts(Noise& noise) const {
    scale(noise.feature_size, noise.units);
    return false;
  }
  bool move_parts(Unify& unify) const {
    if (unify.direction) turn(*unify.direction);
    scale(unify.length, unify.units);
    return false;
  }
  bool move_parts(Length& length) const {
    const bool is_length = length.mode == LengthMode::set || length.mode == LengthMode::add ||
                           length.mode == LengthMode::min || length.mode == LengthMode::max;
    if (is_length) scale(length.value, length.units);
    return false;
  }
  bool move_parts(Trim& trim) const {
    if (auto* plane = std::get_if<TrimPlane>(&trim.shape))
      move(plane->point), plane->normal = map_.normal(plane->normal);
    if (auto* sphere = std::get_if<TrimSphere>(&trim.shape)) move(sphere->centre), scale(sphere->radius, trim.units);
    if (auto* height = std::get_if<double>(&trim.shape)) scale(*height, trim.units);
    return false;
  }
  bool move_parts(ChangeMask& mask) const {
    if (auto* box = std::get_if<MaskBox>(&mask.shape)) {
      const glm::dvec3 a = map_.mapped(box->min), b = map_.mapped(box->max);
      box->min = glm::min(a, b), box->max = glm::max(a, b);
    }
    if (auto* sphere = std::get_if<MaskSphere>(&mask.shape)) move(sphere->centre), scale(sphere->radius, mask.units);
    if (auto* part = std::get_if<MaskPart>(&mask.shape)) move_on_skin(part->position);
    scale(mask.distance, mask.units);
    return false;
  }
  bool move_parts(SetBlowers& command) const {
    for (NamedBlower& named : command.blowers) move_parts(named.blow);
    return false;
  }
  bool move_parts(SetAttractors& command) const {
    for (NamedAttractor& named : command.attractors) move_parts(named.attract);
    return false;
  }
  bool move_parts(SetSymmetry& command) const {
    move(command.symmetry);
    return false;
  }
  bool move_parts(SetEyes& command) const {
    for (Eye& eye : command.eyes) {
      move_on_skin(eye.position), turn(eye.gaze);
      if (eye.look_at) move(*eye.look_at);
      if (eye.lids && eye.lids->facing) turn(*eye.lids->facing);
    }
    return false;
  }
  bool move_parts(SetCurves& command) const {
    for (CurveGroup& group : command.groups) {
      for (GuideCurve& curve : group.curves) move_curve(curve);
    }
    return false;
  }
  bool move_parts(SetSkin& command) const {
    for (SkinRegion& region : command.regions) {
      move_on_skin(region.centre), turn(region.axis);
      if (region.facing) turn(region.facing->direction);
    }
    return false;
  }
  template <Unplaced Other>
  bool move_parts(Other&) const {
    return false;
  }

  const PositionMap& map_;
  const Surface& surface_;
};

}  // namespace

bool move_command(Command& command, const PositionMap& map, const Surface& surface) {
  return std::visit(Mover(map, surface), command);
}

namespace {

/// A rigid motion or a mirror image of the model's space.
struct Motion {
  glm::dmat3 turn{1};
  glm::dvec3 shift{0};

  glm::dvec3 mapped(glm::dvec3 p) const { return turn * p + shift; }
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

/// Returns every motion of the symmetry except the identity.
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

/// Applies a motion to positions. Those on triangles move to the nearest surface positions.
class MotionMap : public PositionMap {
 public:
  MotionMap(const Motion& motion, const Surface& surface) : motion_(motion), surface_(surface) {}

  glm::dvec3 mapped(glm::dvec3 position) const override { return motion_.mapped(position); }
  glm::dvec3 on_skin(glm::dvec3 position) const override { return motion_.mapped(position); }
  SurfaceSample on_skin(const SurfaceSample& sample) const override {
    const Mesh& mesh = surface_.mesh();
    const glm::dvec3 position = mesh.to_model(surface_.position({sample.triangle, sample.barycentric}));
    const SurfacePoint there = surface_.nearest(mesh.to_internal(motion_.mapped(position)));
    return {there.triangle, glm::max(there.barycentric, 0.0)};
  }
  glm::dvec3 direction(glm::dvec3 direction) const override { return motion_.direction(direction); }
  glm::dvec3 normal(glm::dvec3 normal) const override { return motion_.direction(normal); }
  double length(double length) const override { return length; }
  bool mirrors() const override { return glm::determinant(motion_.turn) < 0; }

 private:
  const Motion& motion_;
  const Surface& surface_;
};

/// Adds the keys or curves of an image to those of the whole command; evaluated one after the other, the images would
/// overwrite each other. Returns false for other commands.
bool joins_images(Command& original, const Command& image) {
  if (auto* keys = std::get_if<Interpolate>(&original); keys && !keys->stroke) {
    const auto& more = std::get<Interpolate>(image).keys;
    keys->keys.insert(keys->keys.end(), more.begin(), more.end());
    return true;
  }
  if (auto* flow = std::get_if<Flow>(&original); flow && !flow->stroke) {
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

const Symmetry& symmetry_of(const Command& command, const Symmetry& scene) {
  const Brush* brush = brush_of(command);
  return brush != nullptr && brush->symmetry ? *brush->symmetry : scene;
}

std::vector<Command> symmetry_images(const Command& resolved, const Symmetry& scene, const Surface& surface) {
  std::vector<Command> images{resolved};
  if (is_flood(resolved)) return images;
  for (const Motion& motion : motions_of(symmetry_of(resolved, scene))) {
    Command image = resolved;
    if (!move_command(image, MotionMap(motion, surface), surface)) break;  // the command has no positions
    if (!joins_images(images.front(), image)) images.push_back(std::move(image));
  }
  return images;
}

}  // namespace pelage
