#include <algorithm>
#include <cmath>
#include <limits>

#include "server/fields/field_writer.h"
#include "server/groom/brush.h"
#include "server/groom/standing_fur.h"
#include "server/groom/tools.h"
#include "server/groom/vertex_frame.h"

namespace pelage {

namespace {

constexpr double uncut = std::numeric_limits<double>::infinity();

/// Returns the distance from `root` along `offset`, in lengths of `offset`, at which the sphere's boundary is crossed.
double reach_in_sphere(glm::dvec3 root, glm::dvec3 offset, double radius, bool keep_inside) {
  const double a = glm::dot(offset, offset), b = glm::dot(root, offset), c = glm::dot(root, root) - radius * radius;
  if (keep_inside ? c >= 0 : c <= 0) return 0;
  const double discriminant = b * b - a * c;
  if (!(a > 0) || discriminant < 0) return uncut;
  const double sqrt_discriminant = std::sqrt(discriminant);
  const double first = (-b - sqrt_discriminant) / a, second = (-b + sqrt_discriminant) / a;
  if (keep_inside) return std::max(second, 0.0);
  return first >= 0 ? first : uncut;
}

/// Computes the largest length at which no point of the strand is beyond the shape.
class LongestStrand {
 public:
  LongestStrand(const Trim& command, const Mesh& mesh) : command_(command), mesh_(mesh) {}

  double operator()(const UnitStrand& strand) const {
    double longest = uncut;
    for (std::size_t k = 0; k < UnitStrand::sample_count; ++k)
      longest =
          std::min(longest, std::visit([&](const auto& shape) { return limit(shape, strand, k); }, command_.shape));
    return longest;
  }

 private:
  double limit(const TrimPlane& plane, const UnitStrand& strand, std::size_t k) const {
    const glm::dvec3 normal = safe_unit(plane.normal);
    const double clearance = glm::dot(mesh_.to_internal(plane.point) - strand.root, normal);
    const double climb = glm::dot(strand.offsets[k], normal);
    if (clearance <= 0) return 0;
    return climb > 0 ? clearance / climb : uncut;
  }
  double limit(const TrimSphere& sphere, const UnitStrand& strand, std::size_t k) const {
    const double radius = internal_length(sphere.radius, command_.units, mesh_);
    return reach_in_sphere(strand.root - mesh_.to_internal(sphere.centre), strand.offsets[k], radius,
                           sphere.keep_inside);
  }
  double limit(double height, const UnitStrand& strand, std::size_t k) const {
    const double clearance = internal_length(height, command_.units, mesh_);
    return strand.heights[k] > 0 ? clearance / strand.heights[k] : uncut;
  }

  const Trim& command_;
  const Mesh& mesh_;
};

}  // namespace

Evaluation run(const Trim& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras) {
  const LongestStrand longest(command, surface.mesh());
  const Brush brush = command.stroke ? command.brush : Brush{.strength = 1};
  FieldWriter writer(fields, Field::length);
  for (const auto [v, weight] : region_of(command.stroke, brush, surface, fields, extras)) {
    const double now = fields.length()[v];
    const double cut = std::min(now, longest(strand_at(v, surface.mesh(), fields, extras.coat)));
    writer.put(v, now + weight * (cut - now));
  }
  Evaluation done;
  writer.finish(done.delta);
  return done;
}

}  // namespace pelage
