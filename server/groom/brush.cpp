#include "server/groom/brush.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "base/limits.h"
#include "server/groom/vertex_frame.h"
#include "server/maps/draw_map.h"
#include "server/surface/geodesics.h"

namespace pelage {

namespace {

glm::dvec3 internal_position(const StrokeSample& sample, const Surface& surface) {
  if (const auto* in_space = std::get_if<PositionSample>(&sample.position))
    return surface.mesh().to_internal(in_space->position);
  const auto* on_skin = std::get_if<SurfaceSample>(&sample.position);
  assert(on_skin != nullptr);  // resolve() has replaced pixels
  const glm::dvec3 b = on_skin->barycentric;
  return surface.position({on_skin->triangle, b / (b.x + b.y + b.z)});
}

glm::dvec3 unit_or_zero(glm::dvec3 v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : glm::dvec3(0);
}

}  // namespace

double falloff_weight(Falloff curve, double distance) {
  if (!(distance <= 1)) return 0;
  switch (curve) {
    case Falloff::constant: return 1;
    case Falloff::linear: return 1 - distance;
    case Falloff::smooth: return (1 - distance) * (1 - distance) * (1 + 2 * distance);
    case Falloff::sharp: return (1 - distance) * (1 - distance);
    case Falloff::sphere: return std::sqrt(1 - distance * distance);
  }
  assert(false);
  return 0;
}

const Brush* brush_of(const Command& command) {
  return std::visit(
      [](const auto& tool) -> const Brush* {
        if constexpr (requires { tool.brush; })
          return &tool.brush;
        else
          return nullptr;
      },
      command);
}

Brush* brush_of(Command& command) { return const_cast<Brush*>(brush_of(std::as_const(command))); }

double internal_length(double value, Units units, const Mesh& mesh) {
  return units == Units::world ? value / mesh.size : value;
}

double falloff_weight(const Brush& brush, double distance) {
  if (brush.falloff_points.empty()) return falloff_weight(brush.falloff, distance);
  if (!(distance <= 1)) return 0;
  const double coordinate = std::max(distance, 0.0) * static_cast<double>(brush.falloff_points.size() - 1);
  const auto before = std::min(static_cast<std::size_t>(coordinate), brush.falloff_points.size() - 2);
  return glm::mix(brush.falloff_points[before], brush.falloff_points[before + 1],
                  coordinate - static_cast<double>(before));
}

std::optional<StandingFur> fur_reached(const Brush& brush, const Surface& surface, const FieldSet& fields,
                                       const Coat& coat) {
  if (brush.reach != Reach::fur) return std::nullopt;
  return std::optional<StandingFur>(std::in_place, surface, fields, coat);
}

namespace {

/// The tangent plane of a dab, on which its alpha picture is projected.
class DabPlane {
 public:
  DabPlane(const Dab& dab, const Surface& surface);
  /// Projects a position near the dab to coordinates of the picture, [0, 1].
  glm::dvec2 picture_uv(glm::dvec3 position) const;

 private:
  glm::dvec3 centre_, along_, across_;  // the axes have length 1 / radius
};

DabPlane::DabPlane(const Dab& dab, const Surface& surface) : centre_(dab.centre) {
  constexpr double min_length = 1e-6;
  const glm::dvec3 normal = surface.normal(surface.nearest(dab.centre));
  const auto in_plane = [&](glm::dvec3 v) { return v - glm::dot(v, normal) * normal; };
  along_ = in_plane(dab.motion);
  for (const glm::dvec3 up : {glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)})
    if (!(glm::length(along_) > min_length)) along_ = in_plane(up);
  along_ = glm::normalize(along_) / dab.radius;
  across_ = glm::cross(along_, normal);
}

glm::dvec2 DabPlane::picture_uv(glm::dvec3 position) const {
  const glm::dvec3 apart = position - centre_;
  return glm::clamp(0.5 + 0.5 * glm::dvec2(glm::dot(apart, across_), glm::dot(apart, along_)), 0.0, 1.0);
}

}  // namespace

BrushStroke::BrushStroke(const Stroke& stroke, const Brush& brush, const Surface& surface, const StandingFur* fur,
                         const MapPicture* alpha)
    : brush_(brush), surface_(surface), fur_(fur), alpha_(alpha) {
  for (const StrokeSample& sample : stroke.samples) {
    path_.push_back(
        {internal_position(sample, surface), sample.pressure, std::holds_alternative<SurfaceSample>(sample.position)});
  }
  if (stroke.view) {
    const double aspect = static_cast<double>(stroke.view->width) / stroke.view->height;
    camera_ = place_camera(stroke.view->camera, aspect, surface.mesh());
    view_height_ = stroke.view->height;
  }
  if (!path_.empty()) radius_ = radius_at(path_.front().position);
}

double BrushStroke::radius_at(glm::dvec3 position) const {
  if (brush_.units == RadiusUnits::relative) return brush_.radius;
  if (brush_.units == RadiusUnits::world) return brush_.radius / surface_.mesh().size;
  if (!camera_) return 0;
  const double depth = std::max(glm::dot(position - camera_->position, camera_->forward), 0.0);
  return brush_.radius * 2 * camera_->tan_half_fov * depth / view_height_;
}

double BrushStroke::dab_count() const {
  if (!(radius_ > 0)) return 0;
  double arc = 0;
  for (std::size_t i = 1; i < path_.size(); ++i) arc += glm::distance(path_[i - 1].position, path_[i].position);
  return arc > 0 ? arc / (brush_.spacing * radius_) : 0;
}

Dab BrushStroke::between(const Node& a, const Node& b, double t) const {
  Dab dab{.centre = glm::mix(a.position, b.position, t), .pressure = glm::mix(a.pressure, b.pressure, t)};
  if (a.on_surface && b.on_surface) dab.centre = surface_.position(surface_.nearest(dab.centre));
  dab.radius = radius_at(dab.centre) * (1 - brush_.pressure_to_radius * (1 - dab.pressure));
  return dab;
}

std::vector<Dab> BrushStroke::moving_dabs() const {
  std::vector<Dab> dabs;
  const double step = brush_.spacing * radius_;
  assert(dab_count() <= limits::dabs_per_stroke);
  if (path_.empty() || !(step > 0)) return dabs;
  glm::dvec3 last_centre = path_.front().position;
  const auto put = [&](Dab dab, double arc) {
    dab.motion = unit_or_zero(dab.centre - last_centre);
    dab.step = arc / radius_;
    last_centre = dab.centre;
    dabs.push_back(dab);
  };
  double walked = 0;
  for (std::size_t i = 1; i < path_.size(); ++i) {
    const Node &a = path_[i - 1], &b = path_[i];
    const double length = glm::distance(a.position, b.position);
    // Uses multiples of the step and not sums, so that many dabs do not drift.
    for (double next; (next = static_cast<double>(dabs.size() + 1) * step) <= walked + length;) {
      put(between(a, b, std::clamp((next - walked) / length, 0.0, 1.0)), step);
    }
    walked += length;
  }
  const double remainder = walked - static_cast<double>(dabs.size()) * step;
  if (remainder > 1e-9 * step) put(between(path_.back(), path_.back(), 0), remainder);
  return dabs;
}

std::vector<Dab> BrushStroke::covering_dabs() const {
  std::vector<Dab> dabs = moving_dabs();
  if (!path_.empty()) dabs.insert(dabs.begin(), between(path_.front(), path_.front(), 0));
  if (dabs.size() > 1) dabs.front().motion = dabs[1].motion;
  return dabs;
}

void BrushStroke::reach_fur(const Dab& dab, std::vector<Reached>& reached) const {
  for (const auto [vertex, distance, lift] : fur_->within(dab.centre, dab.radius))
    reached.push_back({vertex, distance / dab.radius, lift});
}

void BrushStroke::reach_through_space(const Dab& dab, std::vector<Reached>& reached) const {
  std::vector<std::uint32_t> found;
  surface_.vertices_within(dab.centre, dab.radius, found);
  for (const std::uint32_t v : found)
    reached.push_back({v, glm::distance(glm::dvec3(surface_.mesh().positions[v]), dab.centre) / dab.radius});
}

void BrushStroke::reach_along_surface(const Dab& dab, std::vector<Reached>& reached) const {
  const SurfacePoint centre = surface_.nearest(dab.centre);
  const double above = glm::distance(surface_.position(centre), dab.centre);
  for (const auto [vertex, distance] : distances_within(surface_, centre, dab.radius))
    reached.push_back({vertex, std::hypot(distance, above) / dab.radius});
}

void BrushStroke::reach_on_screen(const Dab& dab, std::vector<Reached>& reached) const {
  const std::vector<glm::vec3>& positions = surface_.mesh().positions;
  const auto on_plane = [&](glm::dvec3 position) {
    const glm::dvec3 from_camera = position - camera_->position;
    const double depth = glm::dot(from_camera, camera_->forward);
    return depth > 0 ? glm::dvec2(glm::dot(from_camera, camera_->right), glm::dot(from_camera, camera_->up)) / depth
                     : glm::dvec2(std::numeric_limits<double>::infinity());
  };
  const double depth = glm::dot(dab.centre - camera_->position, camera_->forward);
  if (!(depth > 0)) return;
  const glm::dvec2 middle = on_plane(dab.centre);
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    const double distance = glm::distance(on_plane(glm::dvec3(positions[v])), middle) * depth / dab.radius;
    if (distance <= 1) reached.push_back({v, distance});
  }
}

void BrushStroke::weigh(const Dab& dab, std::vector<VertexWeight>& weights) const {
  constexpr double half_diagonal = 0.5 + 1e-6;
  weights.clear();
  const bool screen = brush_.falloff_shape == FalloffShape::screen;
  if (!(dab.radius > 0) ||
      (!screen && glm::length(dab.centre) > half_diagonal + dab.radius + (fur_ ? fur_->longest() : 0)))
    return;
  std::vector<Reached> reached;
  if (screen) {
    if (camera_) reach_on_screen(dab, reached);
  } else if (brush_.falloff_shape == FalloffShape::surface) {
    reach_along_surface(dab, reached);
  } else if (fur_) {
    reach_fur(dab, reached);
  } else {
    reach_through_space(dab, reached);
  }
  if (reached.empty()) return;
  const Mesh& mesh = surface_.mesh();
  const bool judge_by_normal = brush_.front_faces_only && !camera_;
  const glm::dvec3 outwards = judge_by_normal ? surface_.normal(surface_.nearest(dab.centre)) : glm::dvec3(0);
  const double cut_off = brush_.cut_off_degrees == 90 ? 0 : std::cos(glm::radians(brush_.cut_off_degrees));
  const double strength = brush_.strength * (1 - brush_.pressure_to_strength * (1 - dab.pressure));
  const std::optional<DabPlane> plane = alpha_ ? std::optional(DabPlane(dab, surface_)) : std::nullopt;
  for (const auto [v, distance, lift] : reached) {
    const glm::dvec3 position(mesh.positions[v]), normal(mesh.normals[v]);
    const glm::dvec3 front = judge_by_normal || !camera_ ? outwards : safe_unit(camera_->position - position);
    // A tip is visible beyond the silhouette of a body, so the higher on the strand the dab is, the less its root's
    // normal counts.
    if (brush_.front_faces_only && !(glm::dot(normal, front) > cut_off - 2 * lift)) continue;
    double weight = strength * falloff_weight(brush_, distance);
    if (plane) weight *= luminance_at(*alpha_, plane->picture_uv(position));
    if (weight > 0) weights.push_back({v, weight});
  }
}

glm::dvec3 nearest_on_path(const Stroke& stroke, const Surface& surface, glm::dvec3 position) {
  assert(!stroke.samples.empty());
  glm::dvec3 from = internal_position(stroke.samples.front(), surface), best = from;
  for (std::size_t i = 1; i < stroke.samples.size(); ++i) {
    const glm::dvec3 to = internal_position(stroke.samples[i], surface), along = to - from;
    const double square = glm::dot(along, along);
    const double t = square > 0 ? std::clamp(glm::dot(position - from, along) / square, 0.0, 1.0) : 0;
    const glm::dvec3 candidate = from + t * along;
    if (glm::distance(position, candidate) < glm::distance(position, best)) best = candidate;
    from = to;
  }
  return best;
}

namespace {

/// Returns the vertices under the stroke, each with the largest weight of any dab.
std::vector<VertexWeight> covered(const Stroke& stroke, const Brush& brush, const Surface& surface,
                                  const FieldSet& fields, const ToolExtras& extras) {
  const std::optional<StandingFur> fur = fur_reached(brush, surface, fields, extras.coat);
  const BrushStroke painted(stroke, brush, surface, fur ? &*fur : nullptr, extras.alpha);
  std::unordered_map<std::uint32_t, double> largest;
  std::vector<VertexWeight> weights;
  for (const Dab& dab : painted.covering_dabs()) {
    extras.cancel.check();
    painted.weigh(dab, weights);
    for (const auto [vertex, weight] : weights) {
      double& so_far = largest[vertex];
      so_far = std::max(so_far, weight);
    }
  }
  weights.clear();
  for (const auto& [vertex, weight] : largest) weights.push_back({vertex, weight});
  std::sort(weights.begin(), weights.end(), [](auto a, auto b) { return a.vertex < b.vertex; });
  return weights;
}

std::vector<VertexWeight> everywhere(double weight, std::size_t vertices) {
  std::vector<VertexWeight> all;
  if (!(weight > 0)) return all;
  all.resize(vertices);
  for (std::uint32_t v = 0; v < vertices; ++v) all[v] = {v, weight};
  return all;
}

}  // namespace

std::vector<VertexWeight> region_of(const std::optional<Stroke>& stroke, const Brush& brush, const Surface& surface,
                                    const FieldSet& fields, const ToolExtras& extras, Masked masked) {
  std::vector<VertexWeight> region =
      stroke ? covered(*stroke, brush, surface, fields, extras) : everywhere(brush.strength, fields.size());
  if (masked == Masked::no || fields.at_default(Field::mask)) return region;
  for (VertexWeight& entry : region) entry.weight *= fields.number(Field::mask, entry.vertex);
  std::erase_if(region, [](const VertexWeight& entry) { return !(entry.weight > 0); });
  return region;
}

double strand_share(const Brush& brush, Field field) {
  if (field != Field::root_colour && field != Field::tip_colour) return 1;
  const double low = field == Field::root_colour ? 0 : 0.5, high = low + 0.5;
  return std::max(0.0, std::min(brush.strand_to, high) - std::max(brush.strand_from, low)) / 0.5;
}

}  // namespace pelage
