#include "tests/property/groom/command_maker.h"

#include <algorithm>

#include "server/groom/first_groom.h"

namespace pelage::testing_commands {

namespace {

template <std::size_t number = 0>
Command tool_numbered(std::size_t tool) {
  if constexpr (number + 1 < tool_count) {
    if (tool != number) return tool_numbered<number + 1>(tool);
  }
  return Command(std::in_place_index<number>);
}

}  // namespace

Command empty_tool(std::size_t tool) { return tool_numbered(tool); }

double CommandMaker::extreme(std::vector<double> special, double low, double high) {
  if (numbers_ == Numbers::ordinary || chance(0.6)) return random_.uniform(low, high);
  return special[below(special.size())];
}

std::size_t CommandMaker::below(std::size_t count) {
  return std::min(static_cast<std::size_t>(random_.uniform(0, static_cast<double>(count))), count - 1);
}

glm::dvec3 CommandMaker::cube() {
  const double x = random_.uniform(-1, 1), y = random_.uniform(-1, 1), z = random_.uniform(-1, 1);
  return {x, y, z};
}

glm::dvec3 CommandMaker::point() {
  const Mesh& mesh = surface_.mesh();
  const glm::dvec3 vertex(mesh.positions[below(mesh.positions.size())]);
  return mesh.to_model(vertex + extreme({0, 0.2887, 9e5}, 0, 0.1) * cube());
}

glm::dvec3 CommandMaker::heading() {
  const double length = extreme({1e-300, 1e300}, 0.1, 2);
  return length * (cube() + glm::dvec3(0, 0, 1e-3));
}

double CommandMaker::in_units(double sizes, Units units) const {
  return units == Units::world ? sizes * surface_.mesh().size : sizes;
}

View CommandMaker::view() {
  View view;
  view.camera.automatic = AutoView::none;
  view.camera.position = surface_.mesh().to_model(2.0 * cube() + glm::dvec3(0, 0, 0.01));
  view.camera.target = surface_.mesh().to_model(0.1 * cube());
  view.camera.fov_degrees = extreme({1, 150}, 20, 60);
  view.width = 300, view.height = 200;
  return view;
}

Brush CommandMaker::brush() {
  Brush brush;
  brush.radius = extreme({0, 9e5, 1, 1e-6}, 0.05, 0.5);
  brush.falloff_shape = chance(0.6) ? FalloffShape::volume : FalloffShape::surface;
  if (brush.falloff_shape == FalloffShape::volume && chance(0.5)) brush.reach = one_of({Reach::skin, Reach::fur});
  brush.falloff = one_of({Falloff::constant, Falloff::linear, Falloff::smooth, Falloff::sharp, Falloff::sphere});
  if (chance(0.2)) {
    for (std::size_t k = 0; k < 2 + below(5); ++k) brush.falloff_points.push_back(extreme({0, 1}, 0, 1));
    brush.falloff_points.resize(std::max<std::size_t>(brush.falloff_points.size(), 2), 0.5);
  }
  brush.strength = extreme({0, 1}, 0, 1);
  brush.spacing = extreme({0.01, 10}, 0.05, 1);
  brush.pressure_to_radius = extreme({0, 1}, 0, 1);
  brush.pressure_to_strength = extreme({0, 1}, 0, 1);
  brush.front_faces_only = chance(0.5);
  if (chance(0.5)) brush.cut_off_degrees = extreme({0, 180, 90}, 5, 175);
  brush.invert = chance(0.3);
  if (chance(0.2)) brush.symmetry = Symmetry{.planes = {{point(), heading()}}};
  if (chance(0.2)) brush.strand_from = extreme({0, 0.5}, 0, 0.9), brush.strand_to = brush.strand_from + 0.1;
  if (chance(0.3)) brush.units = RadiusUnits::world, brush.radius *= surface_.mesh().size;
  return brush;
}

Stroke CommandMaker::stroke() {
  Stroke stroke;
  const bool on_surface = chance(0.3);
  do {
    StrokeSample sample;
    if (on_surface) {
      const glm::dvec3 shares = (cube() + 1.001) / 2.0;
      sample.position = SurfaceSample{static_cast<std::uint32_t>(below(surface_.mesh().triangles.size())),
                                      shares / (shares.x + shares.y + shares.z)};
    } else if (!stroke.samples.empty() && numbers_ == Numbers::extreme && chance(0.2)) {
      sample.position = stroke.samples.back().position;
    } else {
      sample.position = PositionSample{point()};
    }
    sample.pressure = extreme({0, 1}, 0, 1);
    stroke.samples.push_back(sample);
  } while (chance(0.7) && stroke.samples.size() < 6);
  return stroke;
}

std::vector<Field> CommandMaker::some_fields() {
  std::vector<Field> fields;
  for (std::size_t f = 0; f < field_count; ++f) {
    if (chance(0.4)) fields.push_back(field_at(f));
  }
  if (fields.empty()) fields.push_back(Field::direction);
  return fields;
}

template <class Tool>
Tool CommandMaker::restricted() {
  Tool tool;
  tool.brush = brush();
  tool.stroke = stroke();
  if (views_ == Views::some && chance(0.3)) {
    tool.stroke->view = view();
    if (chance(0.5)) tool.brush.falloff_shape = FalloffShape::screen, tool.brush.reach.reset();
    if (chance(0.5)) tool.brush.units = RadiusUnits::pixels, tool.brush.radius = extreme({0, 9e5, 1}, 10, 100);
  }
  return tool;
}

template <class Tool>
Tool CommandMaker::brushed() {
  Tool tool = restricted<Tool>();
  if constexpr (requires { tool.flood; }) tool.flood = chance(0.3);
  if constexpr (requires { tool.flood; }) {
    if (tool.flood) tool.stroke.reset();
  } else if constexpr (!NeedsStroke<Tool>) {
    if (chance(0.4)) tool.stroke.reset();
  }
  if (!tool.stroke && tool.brush.units == RadiusUnits::pixels) tool.brush.units = RadiusUnits::relative;
  return tool;
}

Command CommandMaker::command(std::size_t number) {
  Command command = empty_tool(number);
  std::visit(
      [&](auto& tool) {
        using Tool = std::decay_t<decltype(tool)>;
        constexpr bool needs_more = std::is_same_v<Tool, ApplyMap> || std::is_same_v<Tool, Retarget>;
        if constexpr (ToolCommand<Tool> && !needs_more) {
          if constexpr (requires { tool.brush; }) tool = brushed<Tool>();
          make(tool);
        }
      },
      command);
  return command;
}

void CommandMaker::make(Comb& comb) {
  comb.lean = extreme({0, 1}, 0, 1);
  comb.keep_inclination = chance(0.3);
  if (comb.flood) comb.direction = heading();
}

void CommandMaker::make(Blow& blow) {
  blow.source = point();
  blow.direction = heading();
  blow.cone_degrees = extreme({0, 90, 180}, 10, 170);
  blow.softness = extreme({0, 1}, 0, 1);
  blow.units = units();
  if (chance(0.5)) blow.fall = in_units(extreme({0, 1e-9, 9e5}, 0.05, 1), blow.units);
  blow.strength = extreme({0, 1}, 0, 1);
  blow.lean = extreme({0, 1}, 0, 1);
}

void CommandMaker::make(Attract& attract) {
  attract.point = point();
  attract.units = units();
  attract.radius = in_units(extreme({0, 9e5}, 0.1, 1), attract.units);
  attract.strength = extreme({0, 1}, 0, 1);
  attract.duration = extreme({0, 1e4, 1e-6}, 0, 3);
  attract.threshold = extreme({0, 1e3}, 0, 2);
  attract.max_stretch = extreme({1, 100}, 1, 10);
}

Key CommandMaker::key(Units units) {
  Key key;
  key.position = point();
  const bool with_direction = chance(0.7);
  if (with_direction) key.direction = heading();
  if (with_direction && chance(0.5)) key.inclination = extreme({0, 1}, 0, 1);
  if (!with_direction || chance(0.5)) key.length = in_units(extreme({0, 9.9}, 0, 0.2), units);
  return key;
}

void CommandMaker::make(Interpolate& interpolate) {
  interpolate.units = units();
  for (std::size_t k = 0; k < 1 + below(4); ++k) interpolate.keys.push_back(key(interpolate.units));
  interpolate.keys.push_back(key(interpolate.units));
  interpolate.sigma = in_units(extreme({1.1e-6, 9e5}, 0.05, 1), interpolate.units);
  if (chance(0.5)) interpolate.reach = in_units(extreme({1.1e-6, 9e5}, 0.05, 1), interpolate.units);
  interpolate.distance = one_of({DistanceKind::straight, DistanceKind::dijkstra, DistanceKind::heat});
  interpolate.strength = extreme({0, 1}, 0, 1);
}

void CommandMaker::make(Flow& flow) {
  flow.units = units();
  for (std::size_t k = 0; k <= below(3); ++k) {
    flow.curves.emplace_back();
    flow.curves.back().push_back(point());
    do flow.curves.back().push_back(point());
    while (chance(0.5));
  }
  flow.sigma = in_units(extreme({1.1e-6, 9e5}, 0.05, 1), flow.units);
  if (chance(0.5)) flow.reach = in_units(extreme({1.1e-6, 9e5}, 0.05, 1), flow.units);
  flow.distance = one_of({DistanceKind::straight, DistanceKind::dijkstra, DistanceKind::heat});
  if (chance(0.5)) flow.inclination = extreme({0, 1}, 0, 1);
  flow.strength = extreme({0, 1}, 0, 1);
}

void CommandMaker::make(Smooth& smooth) {
  smooth.t = extreme({0, 1}, 0, 1);
  smooth.passes = static_cast<int>(extreme({1, 200}, 1, 6));
  smooth.keep_inclination = chance(0.3);
  smooth.fields = some_fields();
}

void CommandMaker::make(Noise& noise) {
  noise.seed = static_cast<std::uint32_t>(below(1000));
  noise.amount = extreme({0, 10}, 0, 1);
  noise.units = units();
  if (chance(0.6)) noise.feature_size = in_units(extreme({0, 1e-9, 1e-7, 9e5}, 0.05, 1), noise.units);
  noise.fields = some_fields();
}

void CommandMaker::make(Unify& unify) {
  if (chance(0.5)) unify.direction = heading();
  if (chance(0.5)) unify.inclination = extreme({0, 1}, 0, 1);
  unify.units = units();
  if (chance(0.5)) unify.length = in_units(extreme({0, 9.9}, 0, 0.2), unify.units);
  if (chance(0.7)) unify.mean = some_fields();
  unify.weight = extreme({0, 1}, 0, 1);
}

void CommandMaker::make(Part& part) { part.lean = extreme({0, 1}, 0, 1); }

void CommandMaker::make(Whorl& whorl) {
  whorl.turn_degrees = extreme({-180, 0, 180}, -180, 180);
  whorl.lean = extreme({0, 1}, 0, 1);
}

void CommandMaker::make(Length& length) {
  length.mode = one_of({LengthMode::set, LengthMode::add, LengthMode::scale, LengthMode::average, LengthMode::jitter,
                        LengthMode::min, LengthMode::max});
  length.units = units();
  length.seed = static_cast<std::uint32_t>(below(1000));
  if (length.mode == LengthMode::scale)
    length.value = extreme({0, 1e6, 5e-324}, 0, 3);
  else if (length.mode == LengthMode::jitter)
    length.value = extreme({0, 1}, 0, 1);
  else
    length.value = in_units(extreme({0, 9.9}, 0, 0.2), length.units);
  if (length.mode == LengthMode::add && chance(0.5)) length.value = -length.value;
}

void CommandMaker::make(Trim& trim) {
  trim.units = units();
  const double kind = random_.uniform();
  if (kind < 0.3)
    trim.shape = TrimPlane{point(), heading()};
  else if (kind < 0.7)
    trim.shape = TrimSphere{point(), in_units(extreme({0, 9e5}, 0.05, 0.8), trim.units), chance(0.5)};
  else
    trim.shape = in_units(extreme({0, 9e5}, 0, 0.1), trim.units);
}

void CommandMaker::make(Lift&) {}

void CommandMaker::make(Erase& erase) {
  if (chance(0.5)) erase.fields = some_fields();
}

void CommandMaker::make(Clump& clump) {
  clump.gather = extreme({0, 1}, 0, 1);
  clump.amount = extreme({0, 1}, 0, 1);
}

void CommandMaker::make(Curl& curl) {
  curl.amount = extreme({0, 1}, 0, 1);
  curl.turn_degrees = extreme({-180, 0, 180}, -180, 180);
}

void CommandMaker::make(Paint& paint) {
  paint.field = one_of({Field::density, Field::width, Field::curl, Field::clump, Field::wetness, Field::bare,
                        Field::mask, Field::root_colour, Field::tip_colour, Field::stiffness});
  paint.value = extreme({0, 1}, 0, 1) * (shape_of(paint.field).max > 1 ? 4 : 1);
  paint.colour = glm::vec3((cube() + 1.0) / 2.0);
}

void CommandMaker::make(ChangeMask& mask) {
  mask.action = one_of({MaskAction::select, MaskAction::grow, MaskAction::shrink, MaskAction::smooth,
                        MaskAction::invert, MaskAction::select});
  mask.combine = one_of({MaskCombine::replace, MaskCombine::add, MaskCombine::subtract, MaskCombine::intersect});
  mask.units = units();
  mask.value = extreme({0, 1}, 0, 1);
  mask.distance = in_units(extreme({0, 9e5}, 0, 0.3), mask.units);
  mask.passes = static_cast<int>(extreme({1, 200}, 1, 6));
  const double kind = random_.uniform();
  if (kind < 0.2) {
    MaskVertices list;
    do list.vertices.push_back(static_cast<std::uint32_t>(below(surface_.mesh().positions.size())));
    while (chance(0.8));
    mask.shape = list;
  } else if (kind < 0.4) {
    const glm::dvec3 a = point(), b = point();
    mask.shape = MaskBox{glm::min(a, b), glm::max(a, b)};
  } else if (kind < 0.7) {
    mask.shape = MaskSphere{point(), in_units(extreme({0, 9e5}, 0.05, 0.5), mask.units), extreme({0, 1}, 0, 1)};
  } else if (kind < 0.9) {
    mask.shape = MaskPart{point()};
  }
}

Coat CommandMaker::coat() {
  Coat coat;
  coat.root_share = extreme({0, 1}, 0, 1);
  coat.lean_curve = chance(0.5) ? LeanCurve::arc : LeanCurve::root;
  return coat;
}

FieldSet CommandMaker::fields() {
  FieldSet fields = first_groom(surface_.mesh(), {extreme({0, 1e-6, 10}, 0, 0.2), extreme({0, 1}, 0, 1)});
  const double share = extreme({0, 1}, 0, 1);
  for (std::uint32_t v = 0; v < fields.size(); ++v) {
    for (std::size_t f = 0; f < field_count; ++f) {
      if (!chance(share)) continue;
      const FieldShape& shape = shape_of(field_at(f));
      glm::vec4 value(0);
      for (int c = 0; c < shape.channels; ++c)
        value[c] = stored_value(field_at(f), extreme({shape.min, shape.max, shape.default_value}, 0, 1));
      if (field_at(f) == Field::direction)
        value = glm::vec4(stored_direction(extreme({0, 1}, 0, 1) * glm::dvec2(cube())), 0, 0);
      if (field_at(f) == Field::length) value *= 0.2f;
      fields.set(field_at(f), v, value);
    }
  }
  return fields;
}

void weaken(Command& command) {
  std::visit(
      [](auto& tool) {
        if constexpr (requires { tool.brush; }) tool.brush.strength = 0;
        if constexpr (requires { tool.strength; }) tool.strength = 0;
      },
      command);
}

}  // namespace pelage::testing_commands
