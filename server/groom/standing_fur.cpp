#include "server/groom/standing_fur.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/lean_curve.h"
#include "server/groom/vertex_frame.h"

namespace pelage {

namespace {

constexpr double half_diagonal = 0.5 + 1e-6;  // radius of a ball around 0 that contains any model

/// Returns the parameter, from 0 at `a` to 1 at `b`, at which the segment is nearest to a position.
double nearest_parameter(glm::dvec3 position, glm::dvec3 a, glm::dvec3 b) {
  const glm::dvec3 along = b - a;
  const double square = glm::dot(along, along);
  return square > 0 ? std::clamp(glm::dot(position - a, along) / square, 0.0, 1.0) : 0;
}

/// The closest approach of a line to a segment: the distance along the line, and the gap.
struct Approach {
  double along, distance;
};
Approach approach(glm::dvec3 origin, glm::dvec3 direction, glm::dvec3 a, glm::dvec3 b) {
  const glm::dvec3 segment = b - a, from = a - origin;
  const double segment_along = glm::dot(segment, direction), from_along = glm::dot(from, direction);
  const double square = glm::dot(segment, segment) - segment_along * segment_along;  // 0 if they are parallel
  const double t =
      square > 0 ? std::clamp((from_along * segment_along - glm::dot(from, segment)) / square, 0.0, 1.0) : 0;
  const double along = from_along + t * segment_along;
  return {along, glm::distance(a + t * segment, origin + along * direction)};
}

}  // namespace

UnitStrand strand_at(std::uint32_t vertex, const Mesh& mesh, const FieldSet& fields, const Coat& coat) {
  const VertexFrame frame = frame_at(mesh, vertex);
  const auto [inclination, along] = lean_of(glm::dvec2(fields.at(vertex).direction), frame.normal, frame.tangent);
  UnitStrand strand;
  strand.root = glm::dvec3(mesh.positions[vertex]);
  for (std::size_t k = 0; k < UnitStrand::sample_count; ++k) {
    const double s = static_cast<double>(k + 1) / UnitStrand::sample_count;
    const LeanPoint position = lean_point(coat.lean_curve, inclination, coat.root_share, s);
    strand.offsets[k] = position.across * along + position.up * frame.normal;
    strand.heights[k] = position.up;
  }
  return strand;
}

double longest_fur(const FieldSet& fields) {
  const std::vector<float>& lengths = fields.length();
  return lengths.empty() ? 0 : double{*std::max_element(lengths.begin(), lengths.end())};
}

double longest_fur_of_all(const FieldSet& fields) {
  double longest = 0;
  for (std::size_t coat = 0; coat < fields.coats(); ++coat)
    longest = std::max(longest, longest_fur(fields.of_coat(static_cast<CoatId>(coat))));
  return longest;
}

/// The best candidate so far: the smallest gap between ray and strand (0 if the strand is hit), and of equal gaps the
/// one nearest to the ray's origin.
struct StandingFur::Hit {
  double gap = std::numeric_limits<double>::infinity(), along = 0;

  void take(double other_gap, double other_along) {
    if (other_gap < gap || (other_gap == gap && other_along < along)) gap = other_gap, along = other_along;
  }
};

StandingFur::StandingFur(const Surface& surface, const FieldSet& fields, const Coat& coat)
    : surface_(surface),
      fields_(fields),
      coat_(coat),
      lengths_(fields.length()),
      densities_(fields.values(Field::density)),
      longest_(longest_fur(fields)) {}

const UnitStrand& StandingFur::strand(std::uint32_t vertex) const {
  const auto [known, added] = strands_.try_emplace(vertex);
  if (added) known->second = strand_at(vertex, surface_.mesh(), fields_, coat_);
  return known->second;
}

StandingFur::Reached StandingFur::nearest(std::uint32_t vertex, glm::dvec3 position) const {
  glm::dvec3 from(surface_.mesh().positions[vertex]);
  Reached reached{vertex, glm::distance(from, position), 0};
  const double length = this->length(vertex);
  if (!(length > 0)) return reached;
  const UnitStrand& unit = strand(vertex);
  double low = 0;
  for (std::size_t k = 0; k < UnitStrand::sample_count; ++k) {
    const glm::dvec3 to = unit.root + length * unit.offsets[k];
    const double t = nearest_parameter(position, from, to);
    const double distance = glm::distance(position, glm::mix(from, to, t));
    if (distance < reached.distance) reached.distance = distance, reached.lift = glm::mix(low, unit.heights[k], t);
    from = to, low = unit.heights[k];
  }
  return reached;
}

std::vector<StandingFur::Reached> StandingFur::within(glm::dvec3 position, double radius) const {
  std::vector<std::uint32_t> roots;
  surface_.vertices_within(position, radius + longest_, roots);
  std::vector<Reached> reached;
  for (const std::uint32_t v : roots) {
    if (glm::distance(glm::dvec3(surface_.mesh().positions[v]), position) > radius + length(v)) continue;
    if (const Reached one = nearest(v, position); one.distance <= radius) reached.push_back(one);
  }
  return reached;
}

void StandingFur::intersect(const Ray& ray, std::uint32_t vertex, double max_gap, Hit& best) const {
  const std::vector<glm::vec3>& positions = surface_.mesh().positions;
  const double length = this->length(vertex);
  if (!(length > 0)) return;
  const glm::dvec3 root(positions[vertex]);
  const auto neighbours = surface_.neighbours(vertex);
  const double edge = neighbours.empty() ? 0 : glm::distance(root, glm::dvec3(positions[neighbours.front()]));
  const double spacing = std::min(edge, length);
  const glm::dvec3 off = root - ray.origin;
  const double along = glm::dot(off, ray.direction), near = spacing + max_gap;
  if (glm::length(off - along * ray.direction) > length + near) return;
  if (best.gap == 0 && along - length > best.along) return;  // the whole strand lies behind the current hit
  const UnitStrand& unit = strand(vertex);
  visits_ += UnitStrand::sample_count;
  glm::dvec3 from = root;
  for (const glm::dvec3& offset : unit.offsets) {
    const glm::dvec3 to = root + length * offset;
    const Approach nearest = approach(ray.origin, ray.direction, from, to);
    if (nearest.distance <= near && nearest.along >= 0 && nearest.along <= ray.length)
      best.take(std::max(nearest.distance - spacing, 0.0), nearest.along);
    from = to;
  }
}

std::optional<glm::dvec3> StandingFur::first_hit(const Ray& ray, double max_gap) const {
  if (!(longest_ > 0)) return std::nullopt;
  const double reach = 2 * longest_ + max_gap, ball = half_diagonal + reach;  // bounds of the roots that may be hit
  const double middle = -glm::dot(ray.origin, ray.direction);
  const double off = glm::length(ray.origin + middle * ray.direction);
  if (!(off < ball)) return std::nullopt;
  const double half = std::sqrt(ball * ball - off * off);
  const double begin = std::max(middle - half, 0.0), end = std::min(middle + half, ray.length);
  if (!(begin <= end)) return std::nullopt;
  Hit best;
  std::vector<std::uint32_t> roots;
  surface_.vertices_along(ray.origin + begin * ray.direction, ray.origin + end * ray.direction, reach, roots);
  visits_ += static_cast<double>(roots.size());
  for (const std::uint32_t v : roots) intersect(ray, v, max_gap, best);
  if (!std::isfinite(best.gap)) return std::nullopt;
  return ray.origin + best.along * ray.direction;
}

}  // namespace pelage
