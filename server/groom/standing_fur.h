// The fur as a brush sees it: one strand at each vertex, shaped by the fields and the coat.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <unordered_map>
#include <vector>

#include "protocol/commands/coat.h"
#include "server/fields/field_set.h"
#include "server/surface/surface.h"

namespace pelage {

/// A strand of length 1 that leans as the fields say. A shorter strand is the same curve, scaled, so that each of its
/// points moves on a straight line towards the root when it is cut.
struct UnitStrand {
  static constexpr int sample_count = 8;  // number of points that approximate the strand

  glm::dvec3 root{0};
  std::array<glm::dvec3, sample_count> offsets{};  // from the root
  std::array<double, sample_count> heights{};      // above the skin
};
UnitStrand strand_at(std::uint32_t vertex, const Mesh& mesh, const FieldSet& fields, const Coat& coat);

/// Returns the largest length of any strand, in sizes; 0 if there is none.
double longest_fur(const FieldSet& fields);
/// Returns the same over all coats.
double longest_fur_of_all(const FieldSet& fields);

/// The standing fur, in internal coordinates. The constructor's arguments must outlive it. Not thread-safe, because it
/// caches strands.
class StandingFur {
 public:
  StandingFur(const Surface& surface, const FieldSet& fields, const Coat& coat);

  struct Ray {
    glm::dvec3 origin, direction;  // unit
    double length = 0;             // maximum hit distance; may be infinite
  };
  struct Reached {
    std::uint32_t vertex;
    double distance;  // sizes
    double lift;      // height above the skin of the strand's nearest point, in strand lengths, [0, 1]; 0 at the root
  };

  /// Returns the strands that come within `radius` of a position, sorted by vertex; a bald vertex counts as a strand of
  /// length 0.
  std::vector<Reached> within(glm::dvec3 position, double radius) const;
  /// Returns the point of a ray nearest to the first strand that it hits. There is a strand at each vertex, and the gap
  /// to its neighbours counts as hit too. If nothing is hit, returns the point nearest to the strand closest to the
  /// ray, if that is within `max_gap` of it.
  std::optional<glm::dvec3> first_hit(const Ray& ray, double max_gap) const;

  /// Returns the length of the strand at a vertex, in sizes; 0 if the coat has no strand there.
  double length(std::uint32_t vertex) const {
    if (lengths_.empty() || (!densities_.empty() && !(densities_[vertex] > 0))) return 0;
    return lengths_[vertex];
  }
  double longest() const { return longest_; }
  /// Returns the number of visits by all rays so far (EvaluationCost).
  double visits() const { return visits_; }

 private:
  struct Hit;
  const UnitStrand& strand(std::uint32_t vertex) const;
  Reached nearest(std::uint32_t vertex, glm::dvec3 position) const;
  void intersect(const Ray& ray, std::uint32_t vertex, double max_gap, Hit& best) const;

  const Surface& surface_;
  const FieldSet& fields_;
  const Coat& coat_;
  const std::vector<float>&lengths_, &densities_;
  double longest_ = 0;
  mutable double visits_ = 0;
  mutable std::unordered_map<std::uint32_t, UnitStrand> strands_;
};

}  // namespace pelage
