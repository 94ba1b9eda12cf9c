#include "tests/property/groom/move_command.h"

#include <type_traits>
#include <utility>

namespace pelage::testing_commands {

namespace {

class Mover {
 public:
  Mover(const Motion& motion, const Mesh& from, const Mesh& to, const std::vector<std::uint32_t>& new_indices)
      : motion_(motion), from_(from), to_(to), new_indices_(new_indices), size_(from.size) {}

  template <class Tool>
  void operator()(Tool& tool) const {
    if constexpr (requires { tool.brush; }) move(tool.brush);
    if constexpr (requires { tool.stroke; }) {
      if (tool.stroke) move(*tool.stroke);
    }
    if constexpr (requires { tool.units; }) move_lengths(tool), tool.units = Units::world;
    if constexpr (requires { tool.turn_degrees; }) {
      if (glm::determinant(motion_.turn) < 0) tool.turn_degrees = -tool.turn_degrees;
    }
    move_parts(tool);
  }

 private:
  void move_point(glm::dvec3& p) const { p = motion_.mapped(p); }
  void turn(glm::dvec3& d) const { d = motion_.turn * d; }
  void turn(std::optional<glm::dvec3>& d) const {
    if (d) turn(*d);
  }
  void length(double& value, Units units) const { value *= motion_.scale * (units == Units::relative ? size_ : 1); }
  void length(std::optional<double>& value, Units units) const {
    if (value) length(*value, units);
  }
  void move(Brush& brush) const {
    length(brush.radius, brush.units == RadiusUnits::relative ? Units::relative : Units::world);
    brush.units = RadiusUnits::world;
    if (!brush.symmetry) return;
    for (Plane& plane : brush.symmetry->planes) move_point(plane.point), turn(plane.normal);
    move_point(brush.symmetry->axis_point), turn(brush.symmetry->axis);
  }
  void move(Stroke& stroke) const {
    for (StrokeSample& sample : stroke.samples) {
      if (auto* in_space = std::get_if<PositionSample>(&sample.position)) move_point(in_space->position);
      if (auto* on_skin = std::get_if<SurfaceSample>(&sample.position)) move(*on_skin);
    }
  }
  /// Keeps the triangle; its corners may come in another order.
  void move(SurfaceSample& sample) const {
    const glm::dvec3 before = sample.barycentric;
    const glm::uvec3 old_corners = from_.triangles[sample.triangle], corners = to_.triangles[sample.triangle];
    for (int k = 0; k < 3; ++k) {
      for (int j = 0; j < 3; ++j) {
        if (corners[k] == new_indices_[old_corners[j]]) sample.barycentric[k] = before[j];
      }
    }
  }

  template <class Tool>
  void move_lengths(Tool& tool) const {
    if constexpr (requires { tool.radius; }) length(tool.radius, tool.units);
    if constexpr (requires { tool.fall; }) length(tool.fall, tool.units);
    if constexpr (requires { tool.sigma; }) length(tool.sigma, tool.units), length(tool.reach, tool.units);
    if constexpr (requires { tool.feature_size; }) length(tool.feature_size, tool.units);
    if constexpr (requires {
                    tool.distance;
                    tool.combine;
                  })
      length(tool.distance, tool.units);
    if constexpr (requires { tool.length; }) length(tool.length, tool.units);
    if constexpr (std::is_same_v<Tool, Length>) {
      if (tool.mode != LengthMode::scale && tool.mode != LengthMode::jitter) length(tool.value, tool.units);
    }
    if constexpr (std::is_same_v<Tool, Interpolate>) {
      for (Key& key : tool.keys) length(key.length, tool.units);
    }
    if constexpr (std::is_same_v<Tool, Trim>) {
      if (auto* height = std::get_if<double>(&tool.shape)) length(*height, tool.units);
      if (auto* sphere = std::get_if<TrimSphere>(&tool.shape)) length(sphere->radius, tool.units);
    }
    if constexpr (std::is_same_v<Tool, ChangeMask>) {
      if (auto* sphere = std::get_if<MaskSphere>(&tool.shape)) length(sphere->radius, tool.units);
    }
  }

  void move_parts(Comb& comb) const { turn(comb.direction); }
  void move_parts(Blow& blow) const { move_point(blow.source), turn(blow.direction); }
  void move_parts(Attract& attract) const { move_point(attract.point); }
  void move_parts(Unify& unify) const { turn(unify.direction); }
  void move_parts(Interpolate& command) const {
    for (Key& key : command.keys) move_point(key.position), turn(key.direction);
  }
  void move_parts(Flow& command) const {
    for (auto& curve : command.curves) {
      for (glm::dvec3& point : curve) move_point(point);
    }
  }
  void move_parts(Trim& trim) const {
    if (auto* plane = std::get_if<TrimPlane>(&trim.shape)) move_point(plane->point), turn(plane->normal);
    if (auto* sphere = std::get_if<TrimSphere>(&trim.shape)) move_point(sphere->centre);
  }
  void move_parts(ChangeMask& mask) const {
    if (auto* sphere = std::get_if<MaskSphere>(&mask.shape)) move_point(sphere->centre);
    if (auto* part = std::get_if<MaskPart>(&mask.shape)) move_point(part->position);
  }
  void move_parts(Noise&) const {}
  void move_parts(Length&) const {}
  template <class Other>
  void move_parts(Other&) const {
    static_assert(Unplaced<Other> || SettingCommand<Other>, "what this tool has in the model is not moved");
  }

  const Motion& motion_;
  const Mesh &from_, &to_;
  const std::vector<std::uint32_t>& new_indices_;
  double size_;
};

}  // namespace

Command moved(const Command& command, const Motion& motion, const Surface& from, const Surface& to,
              const std::vector<std::uint32_t>& new_indices) {
  Command other = command;
  std::visit(Mover(motion, from.mesh(), to.mesh(), new_indices), other);
  renumber_vertices(other, new_indices);
  return other;
}

void renumber_vertices(Command& command, const std::vector<std::uint32_t>& new_indices) {
  auto* mask = std::get_if<ChangeMask>(&command);
  auto* list = mask ? std::get_if<MaskVertices>(&mask->shape) : nullptr;
  if (!list) return;
  for (std::uint32_t& vertex : list->vertices) vertex = new_indices[vertex];
}

}  // namespace pelage::testing_commands
