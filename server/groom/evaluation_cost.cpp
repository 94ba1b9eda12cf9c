#include "server/groom/evaluation_cost.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/limits.h"
#include "server/groom/brush.h"
#include "server/groom/evaluate.h"
#include "server/groom/standing_fur.h"

namespace pelage {

namespace {

// Approximate cost of an operation, in visits.
constexpr double dab_visits = 32;                           // searching the vertices of a dab, however few
constexpr double along_surface = 30;                        // each vertex of a dab with the surface shape
constexpr double nearest_visits = 50;                       // a query for the nearest surface position
constexpr double ring_visits = 8;                           // a vertex and its neighbours
constexpr double strand_visits = UnitStrand::sample_count;  // the distance to a strand
constexpr double edges_visits = 16;                         // each vertex of a search along edges
constexpr double heat_visits = 400;                         // each vertex of a distance by the heat method
constexpr double curve_step = 0.01, curve_steps = 4096;     // flow's steps along curves: sizes; maximum per segment

/// Returns the number of vertices under a dab: the mean over at most 16 samples, spread over the stroke.
double typical_reach(const Stroke& stroke, const Brush& brush, const Surface& surface, double longest_fur) {
  constexpr std::size_t sample_count = 16;
  const std::size_t count = std::min(sample_count, stroke.samples.size());
  if (count == 0) return 0;
  std::size_t sum = 0;
  std::vector<std::uint32_t> found;
  for (std::size_t k = 0; k < count; ++k) {
    Stroke one;
    one.samples = {stroke.samples[k * stroke.samples.size() / count]}, one.view = stroke.view;
    const Dab dab = BrushStroke(one, brush, surface).covering_dabs().front();
    found.clear();
    const double around = brush.reach == Reach::fur ? longest_fur : 0;
    if (dab.radius > 0) surface.vertices_within(dab.centre, dab.radius + around, found);
    sum += found.size();
  }
  return static_cast<double>(sum) / static_cast<double>(count);
}

/// The work of a stroke, for one symmetry image.
struct StrokeWork {
  double visits = 0;
  double region = 0;  // upper bound of the number of vertices under it
};

StrokeWork work_of(const Stroke& stroke, const Brush& brush, const Surface& surface, double longest_fur) {
  const auto vertices = static_cast<double>(surface.mesh().positions.size());
  const BrushStroke painted(stroke, brush, surface);
  const double dabs = std::min(painted.dab_count(), double{limits::dabs_per_stroke}) + 2;
  const double reach = typical_reach(stroke, brush, surface, longest_fur),
               samples = static_cast<double>(stroke.samples.size());
  const bool screen = brush.falloff_shape == FalloffShape::screen;
  const bool surface_shape = brush.falloff_shape == FalloffShape::surface;
  const double straight = brush.reach == Reach::fur ? strand_visits * reach : reach;
  const double each = screen ? vertices : surface_shape ? nearest_visits + along_surface * reach : straight;
  return {samples * nearest_visits + dabs * (dab_visits + nearest_visits + each), std::min(vertices, dabs * reach)};
}

/// The work of a tool at the vertices that it changes, without finding them, for one symmetry image.
struct ToolWork {
  const Mesh& mesh;
  double region;   // vertices
  double samples;  // number of samples of the stroke

  double vertices() const { return static_cast<double>(mesh.positions.size()); }
  double spread(DistanceKind kind) const {
    if (kind == DistanceKind::straight) return vertices();
    return vertices() * (kind == DistanceKind::heat ? heat_visits : edges_visits);
  }
  double steps_of(const std::vector<glm::dvec3>& curve) const {
    double steps = 0;
    for (std::size_t i = 1; i < curve.size(); ++i) {
      const double length = glm::distance(mesh.to_internal(curve[i - 1]), mesh.to_internal(curve[i]));
      steps += std::clamp(std::ceil(length / curve_step), 1.0, curve_steps) + 1;
    }
    return steps;
  }

  EvaluationCost operator()(const Smooth& command) const {
    return {region * ring_visits * command.passes * static_cast<double>(command.fields.size()), "/passes"};
  }
  EvaluationCost operator()(const ChangeMask& command) const {
    if (command.action == MaskAction::smooth) return {vertices() * ring_visits * command.passes, "/passes"};
    return {vertices() * edges_visits, "/distance"};
  }
  EvaluationCost operator()(const Interpolate& command) const {
    return {static_cast<double>(command.keys.size()) * (spread(command.distance) + region), "/keys"};
  }
  EvaluationCost operator()(const Flow& command) const {
    double visits = 0;
    for (const auto& curve : command.curves)
      visits += spread(command.distance) + region + nearest_visits * steps_of(curve);
    return {visits, "/curves"};
  }
  EvaluationCost operator()(const Retarget&) const { return {vertices() * nearest_visits, "/scene"}; }
  template <ToolCommand Tool>
  requires(Tool::work != Work::own) EvaluationCost operator()(const Tool&) const {
    if (Tool::work == Work::vertices_x_samples) return {region * samples, "/stroke/samples"};
    return {region, ""};
  }
  template <SettingCommand Setting>
  EvaluationCost operator()(const Setting&) const {
    return {0, ""};
  }
};

bool has_images(const Command& command) {
  return stroke_of(command) != nullptr || std::holds_alternative<Blow>(command) ||
         std::holds_alternative<Attract>(command) || std::holds_alternative<Interpolate>(command) ||
         std::holds_alternative<Flow>(command);
}

}  // namespace

double image_count(const Symmetry& symmetry) {
  return std::ldexp(std::max(symmetry.count, 1), static_cast<int>(symmetry.planes.size()));
}

EvaluationCost evaluation_cost(const Command& resolved, const Symmetry& symmetry, const Surface& surface,
                               double longest_fur) {
  const Mesh& mesh = surface.mesh();
  StrokeWork stroke{0, static_cast<double>(mesh.positions.size())};
  double samples = 0;
  if (const Stroke* drawn = stroke_of(resolved)) {
    stroke = work_of(*drawn, *brush_of(resolved), surface, longest_fur);
    samples = static_cast<double>(drawn->samples.size());
  }
  EvaluationCost cost = std::visit(ToolWork{mesh, stroke.region, samples}, resolved);
  if (stroke.visits > cost.visits) cost.field = "/stroke/samples";
  cost.visits += stroke.visits;
  if (has_images(resolved)) cost.visits *= image_count(symmetry_of(resolved, symmetry));
  return cost;
}

Status add_cost(const Command& resolved, const Symmetry& symmetry, const Surface& surface, double longest_fur,
                double& visits) {
  const EvaluationCost cost = evaluation_cost(resolved, symmetry, surface, longest_fur);
  visits += cost.visits;
  if (visits <= limits::evaluation_visits) return {};
  return failure(Code::invalid, "the commands are too much work, images of the symmetry included", cost.field,
                 fmt::format("at most {:.0f} visits of vertices in a request", limits::evaluation_visits));
}

}  // namespace pelage
