#include "tests/property/groom/reference/brush.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/property/groom/reference/spread.h"

namespace pelage::plain {

namespace {

constexpr double pi = 3.14159265358979323846;

/// The stroke's camera. The tests always give its position themselves.
struct Eye {
  dvec3 position, right, up, forward;
  double half = 0;  // half of the picture's height at distance 1
};

Eye eye_of(const View& view, const Body& body) {
  Eye eye;
  eye.position = body.inside(view.camera.position);
  eye.forward = unit(body.inside(view.camera.target) - eye.position);
  eye.right = unit(glm::cross(eye.forward, view.camera.up));
  eye.up = glm::cross(eye.right, eye.forward);
  eye.half = std::tan(glm::radians(view.camera.fov_degrees) / 2);
  return eye;
}

double radius_at(dvec3 position, const Stroke& stroke, const Brush& brush, const Body& body) {
  if (brush.units == RadiusUnits::relative) return brush.radius;
  if (brush.units == RadiusUnits::world) return brush.radius / body.surface.mesh().size;
  const Eye eye = eye_of(*stroke.view, body);
  const double depth = std::max(0.0, glm::dot(position - eye.position, eye.forward));
  return brush.radius * 2 * eye.half * depth / stroke.view->height;
}

/// The brush at a fraction `t` between two samples. Between surface samples it follows the surface.
Print between(const StrokeSample& a, const StrokeSample& b, double t, const Stroke& stroke, const Brush& brush,
              const Body& body) {
  Print print;
  print.centre = glm::mix(position_of(a, body), position_of(b, body), t);
  if (std::holds_alternative<SurfaceSample>(a.position) && std::holds_alternative<SurfaceSample>(b.position))
    print.centre = body.surface.position(body.surface.nearest(print.centre));
  print.pressure = (1 - t) * a.pressure + t * b.pressure;
  const double factor = 1 - brush.pressure_to_radius + brush.pressure_to_radius * print.pressure;
  print.radius = factor * radius_at(print.centre, stroke, brush, body);
  return print;
}

/// Distances of all vertices from the dab, over its radius.
std::vector<double> distances_of(const Print& print, const Stroke& stroke, const Brush& brush, const Body& body,
                                 const std::optional<Standing>& standing) {
  std::vector<double> distances(body.size(), std::numeric_limits<double>::infinity());
  if (standing) {
    for (Vertex v = 0; v < body.size(); ++v)
      distances[v] = glm::distance(nearest_of(standing->strands[v], print.centre).at, print.centre);
  } else if (brush.falloff_shape == FalloffShape::volume) {
    for (Vertex v = 0; v < body.size(); ++v) distances[v] = glm::distance(body.positions[v], print.centre);
  } else if (brush.falloff_shape == FalloffShape::surface) {
    const SurfacePoint nearest = body.surface.nearest(print.centre);
    const double above = glm::distance(body.surface.position(nearest), print.centre);
    distances = marched_distances(body, nearest, print.radius);
    for (double& distance : distances) distance = std::sqrt(distance * distance + above * above);
  } else {
    const Eye eye = eye_of(*stroke.view, body);
    const auto seen = [&](dvec3 p) {
      const double depth = glm::dot(p - eye.position, eye.forward);
      return dvec3(glm::dot(p - eye.position, eye.right) / depth, glm::dot(p - eye.position, eye.up) / depth, depth);
    };
    const dvec3 middle = seen(print.centre);
    for (Vertex v = 0; v < body.size(); ++v) {
      const dvec3 there = seen(body.positions[v]);
      if (middle.z > 0 && there.z > 0) distances[v] = middle.z * glm::distance(dvec2(there), dvec2(middle));
    }
  }
  for (double& distance : distances) distance /= print.radius;
  return distances;
}

}  // namespace

dvec3 position_of(const StrokeSample& sample, const Body& body) {
  if (const auto* in_space = std::get_if<PositionSample>(&sample.position)) return body.inside(in_space->position);
  // The tools compute exactly this, to the last bit: dabs between two samples often lie on an edge, where the last bit
  // decides in which triangle the march along the surface begins.
  const auto& on_skin = std::get<SurfaceSample>(sample.position);
  const double sum = on_skin.barycentric.x + on_skin.barycentric.y + on_skin.barycentric.z;
  return body.surface.position({on_skin.triangle, on_skin.barycentric / sum});
}

std::vector<Print> prints_of(const Stroke& stroke, const Brush& brush, const Body& body, bool begin) {
  const std::vector<StrokeSample>& samples = stroke.samples;
  std::vector<Print> prints;
  if (samples.empty()) return prints;
  Print first = between(samples[0], samples[0], 0, stroke, brush, body);
  const dvec3 start = position_of(samples[0], body);
  const double radius = radius_at(start, stroke, brush, body), step = brush.spacing * radius;
  dvec3 last = start;
  double before = 0;  // arc length up to the sample
  const auto put = [&](Print print, double arc) {
    print.arc = arc / radius;
    print.motion = unit(print.centre - last);
    last = print.centre;
    prints.push_back(print);
  };
  for (std::size_t i = 1; i < samples.size() && step > 0; ++i) {
    const double length = glm::distance(position_of(samples[i - 1], body), position_of(samples[i], body));
    for (double k = static_cast<double>(prints.size()) + 1; k * step <= before + length; ++k) {
      const double t = std::clamp((k * step - before) / length, 0.0, 1.0);
      put(between(samples[i - 1], samples[i], t, stroke, brush, body), step);
    }
    before += length;
  }
  const double left = before - static_cast<double>(prints.size()) * step;
  if (step > 0 && left > 1e-9 * step) put(between(samples.back(), samples.back(), 0, stroke, brush, body), left);
  if (begin) prints.insert(prints.begin(), first);
  return prints;
}

double strand_part(const Brush& brush, Field field) {
  const auto below_half = [](double s) { return s < 0.5 ? 2 * s : 1; };
  const auto above_half = [](double s) { return s > 0.5 ? 2 * s - 1 : 0; };
  if (field == Field::root_colour) return below_half(brush.strand_to) - below_half(brush.strand_from);
  if (field == Field::tip_colour) return above_half(brush.strand_to) - above_half(brush.strand_from);
  return 1;
}

double falloff_at(const Brush& brush, double d) {
  if (!(d <= 1)) return 0;
  if (!brush.falloff_points.empty()) {
    const std::size_t segments = brush.falloff_points.size() - 1;
    for (std::size_t k = 0; k < segments; ++k) {
      const double from = static_cast<double>(k) / static_cast<double>(segments);
      const double to = static_cast<double>(k + 1) / static_cast<double>(segments);
      if (d > to && k + 1 < segments) continue;
      return brush.falloff_points[k] +
             (brush.falloff_points[k + 1] - brush.falloff_points[k]) * (d - from) / (to - from);
    }
  }
  if (brush.falloff == Falloff::constant) return 1;
  if (brush.falloff == Falloff::linear) return 1 - d;
  if (brush.falloff == Falloff::smooth) return 1 - 3 * d * d + 2 * d * d * d;
  if (brush.falloff == Falloff::sharp) return 1 - 2 * d + d * d;
  return std::sqrt(std::max(0.0, 1 - d * d));
}

std::vector<double> weights_of(const Print& print, const Stroke& stroke, const Brush& brush, const Body& body,
                               const std::optional<Standing>& standing) {
  std::vector<double> weights(body.size(), 0.0);
  if (!(print.radius > 0)) return weights;
  const std::vector<double> distances = distances_of(print, stroke, brush, body, standing);
  const dvec3 skin = body.surface.normal(body.surface.nearest(print.centre));
  const double cosine = std::cos(brush.cut_off_degrees * pi / 180);
  const double pressure = 1 - brush.pressure_to_strength + brush.pressure_to_strength * print.pressure;
  for (Vertex v = 0; v < body.size(); ++v) {
    const dvec3 front = stroke.view ? unit(eye_of(*stroke.view, body).position - body.positions[v]) : skin;
    const double lift = standing ? nearest_of(standing->strands[v], print.centre).lift : 0;
    if (brush.front_faces_only && glm::dot(front, body.normals[v]) <= cosine - 2 * lift) continue;
    weights[v] = brush.strength * pressure * falloff_at(brush, distances[v]);
  }
  return weights;
}

std::vector<double> region_of(const std::optional<Stroke>& stroke, const Brush& brush, const Stage& stage,
                              const Fur& fur, bool masked) {
  const Body& body = stage.body;
  std::vector<double> region(body.size(), stroke ? 0.0 : brush.strength);
  if (stroke) {
    const std::optional<Standing> standing = standing_of(brush, stage, fur);
    for (const Print& print : prints_of(*stroke, brush, body, true)) {
      const std::vector<double> weights = weights_of(print, *stroke, brush, body, standing);
      for (Vertex v = 0; v < body.size(); ++v) region[v] = std::max(region[v], weights[v]);
    }
  }
  for (Vertex v = 0; v < body.size() && masked; ++v) region[v] *= fur.number(Field::mask, v);
  return region;
}

std::vector<double> restriction_of(const std::optional<Stroke>& stroke, const Brush& brush, const Stage& stage,
                                   const Fur& fur) {
  Brush whole;
  whole.strength = 1;
  return region_of(stroke, stroke ? brush : whole, stage, fur);
}

dvec3 nearest_of_path(const Stroke& stroke, const Body& body, dvec3 position) {
  dvec3 best = position_of(stroke.samples[0], body);
  for (std::size_t i = 1; i < stroke.samples.size(); ++i) {
    const dvec3 a = position_of(stroke.samples[i - 1], body), ab = position_of(stroke.samples[i], body) - a;
    const double whole = glm::dot(ab, ab);
    if (whole == 0) continue;
    const dvec3 there = a + std::clamp(glm::dot(position - a, ab) / whole, 0.0, 1.0) * ab;
    if (glm::distance(position, there) < glm::distance(position, best)) best = there;
  }
  return best;
}

}  // namespace pelage::plain
