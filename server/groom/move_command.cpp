#include "server/groom/move_command.h"

#include "server/groom/brush.h"

namespace pelage {

namespace {

class Mover {
 public:
  Mover(const PlaceMap& map, const Surface& surface) : map_(map), surface_(surface) {}

  template <class Tool>
  bool operator()(Tool& tool) const {
    bool moved = false;
    if constexpr (requires { tool.stroke; }) {
      if (tool.stroke) {
        without_view(tool.brush, *tool.stroke);
        move(*tool.stroke), moved = true;
      }
      if (tool.brush.units == RadiusUnits::world) tool.brush.radius = map_.length(tool.brush.radius);
    }
    if constexpr (requires { tool.turn_degrees; }) {
      if (map_.mirrors()) tool.turn_degrees = -tool.turn_degrees;
    }
    return move_parts(tool) || moved;
  }

 private:
  void move(glm::dvec3& place) const { place = map_.place(place); }
  void move_on_skin(glm::dvec3& place) const { place = map_.on_skin(place); }
  /// A curve in space that grows from its first point.
  void move_curve(GuideCurve& curve) const {
    const glm::dvec3 root = map_.on_skin(curve.front()), shift = root - map_.place(curve.front());
    for (glm::dvec3& point : curve) point = map_.place(point) + shift;
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
      if (auto* place = std::get_if<PositionSample>(&sample.place)) move_on_skin(place->position);
      if (auto* place = std::get_if<SurfaceSample>(&sample.place)) *place = map_.on_skin(*place);
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
    scale(command.sigma, command.units);
    return true;
  }
  bool move_parts(Flow& command) const {
    for (std::vector<glm::dvec3>& curve : command.curves) {
      for (glm::dvec3& point : curve) move_on_skin(point);
    }
    scale(command.sigma, command.units);
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
      const glm::dvec3 a = map_.place(box->min), b = map_.place(box->max);
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
    for (Plane& plane : command.symmetry.planes) move(plane.point), plane.normal = map_.normal(plane.normal);
    move(command.symmetry.axis_point), turn(command.symmetry.axis);
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

  const PlaceMap& map_;
  const Surface& surface_;
};

}  // namespace

bool move_command(Command& command, const PlaceMap& map, const Surface& surface) {
  return std::visit(Mover(map, surface), command);
}

}  // namespace pelage
