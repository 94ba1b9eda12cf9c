#include "server/groom/brush.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <unordered_map>

#include "protocol/base/limits.h"
#include "server/groom/evaluate.h"

namespace pelage {

namespace {

glm::dvec3 internal_position(const StrokeSample& sample, const Surface& surface) {
  if (const auto* place = std::get_if<PositionPlace>(&sample.place)) return surface.mesh().to_internal(place->position);
  const auto* place = std::get_if<SurfacePlace>(&sample.place);
  assert(place != nullptr);  // resolve replaces pixels
  const glm::dvec3 b = place->barycentric;
  return surface.position({place->triangle, b / (b.x + b.y + b.z)});
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

double internal_length(double value, Units units, const Mesh& mesh) {
  return units == Units::world ? value / mesh.size : value;
}

BrushStroke::BrushStroke(const Stroke& stroke, const Brush& brush, const Surface& surface, const FieldSet& fields)
    : brush_(brush),
      surface_(surface),
      fields_(fields),
      radius_(internal_length(brush.radius, brush.units, surface.mesh())) {
  for (const StrokeSample& sample : stroke.samples) {
    path_.push_back(
        {internal_position(sample, surface), sample.pressure, std::holds_alternative<SurfacePlace>(sample.place)});
  }
  if (!stroke.view) return;
  const double aspect = static_cast<double>(stroke.view->width) / stroke.view->height;
  eye_ = place_camera(stroke.view->camera, aspect, surface.mesh()).eye;
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
    // Multiples and not sums of the step: many dabs must not drift.
    for (double next; (next = static_cast<double>(dabs.size() + 1) * step) <= walked + length;) {
      put(between(a, b, std::clamp((next - walked) / length, 0.0, 1.0)), step);
    }
    walked += length;
  }
  const double rest = walked - static_cast<double>(dabs.size()) * step;
  if (rest > 1e-9 * step) put(between(path_.back(), path_.back(), 0), rest);
  return dabs;
}

std::vector<Dab> BrushStroke::covering_dabs() const {
  std::vector<Dab> dabs = moving_dabs();
  if (!path_.empty()) dabs.insert(dabs.begin(), between(path_.front(), path_.front(), 0));
  return dabs;
}

void BrushStroke::weigh(const Dab& dab, std::vector<VertexWeight>& weights) const {
  constexpr double half_diagonal = 0.5 + 1e-6;
  weights.clear();
  if (!(radius_ > 0) || glm::length(dab.centre) > half_diagonal + radius_) return;
  std::vector<std::uint32_t> found;
  surface_.vertices_within(dab.centre, radius_, found);
  if (found.empty()) return;
  const Mesh& mesh = surface_.mesh();
  const bool judge_by_normal = brush_.front_faces_only && !eye_;
  const glm::dvec3 outwards = judge_by_normal ? surface_.normal(surface_.nearest(dab.centre)) : glm::dvec3(0);
  for (const std::uint32_t v : found) {
    const glm::dvec3 position(mesh.positions[v]), normal(mesh.normals[v]);
    const glm::dvec3 front = judge_by_normal ? outwards : eye_.value_or(position) - position;
    if (brush_.front_faces_only && !(glm::dot(normal, front) > 0)) continue;
    const double falloff = falloff_weight(brush_.falloff, glm::distance(position, dab.centre) / radius_);
    const double weight = brush_.strength * falloff * dab.pressure * fields_.number(Field::mask, v);
    if (weight > 0) weights.push_back({v, weight});
  }
}

std::vector<VertexWeight> coverage(const Stroke& stroke, const Brush& brush, const Surface& surface,
                                   const FieldSet& fields) {
  const BrushStroke painted(stroke, brush, surface, fields);
  std::unordered_map<std::uint32_t, double> largest;
  std::vector<VertexWeight> weights;
  for (const Dab& dab : painted.covering_dabs()) {
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

std::vector<VertexWeight> reach(const std::optional<Stroke>& stroke, const Brush& brush, double weight,
                                const Surface& surface, const FieldSet& fields) {
  if (stroke) return coverage(*stroke, brush, surface, fields);
  std::vector<VertexWeight> all;
  if (!(weight > 0)) return all;
  all.reserve(fields.size());
  for (std::uint32_t v = 0; v < fields.size(); ++v) {
    const double share = weight * fields.number(Field::mask, v);
    if (share > 0) all.push_back({v, share});
  }
  return all;
}

}  // namespace pelage
