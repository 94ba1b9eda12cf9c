// The fur that stands on a surface, as a brush reaches it: at each vertex the strand that the fields and the coat
// shape.
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

/// A strand of length 1 that leans as the field says. A shorter one is the same curve, smaller, so that each of its
/// places moves along a straight line from the root as it is cut.
struct UnitStrand {
  static constexpr int places = 8;  // along a strand that are looked at

  glm::dvec3 root{0};
  std::array<glm::dvec3, places> offsets{};  // from the root
  std::array<double, places> heights{};      // over the skin
};
UnitStrand strand_at(std::uint32_t vertex, const Mesh& mesh, const FieldSet& fields, const Coat& coat);

/// Returns the longest fur, sizes; 0 where all is bald.
double longest_fur(const FieldSet& fields);
/// The same of all coats.
double longest_fur_of_all(const FieldSet& fields);

/// The standing fur in internal coordinates. Its arguments have to outlive it. It is for one thread, because it caches
/// strands.
class StandingFur {
 public:
  StandingFur(const Surface& surface, const FieldSet& fields, const Coat& coat);

  struct Ray {
    glm::dvec3 origin, direction;  // unit
    double length = 0;             // nothing beyond it is hit; may be infinite
  };
  struct Reached {
    std::uint32_t vertex;
    double distance;  // sizes
    double lift;      // how high over the skin its nearest point is, in its lengths: 0 at its root, at most 1
  };

  /// Strands that come within `radius` of a place, in rising order of their vertices; bald vertices count as roots.
  std::vector<Reached> within(glm::dvec3 place, double radius) const;
  /// Returns the point of a ray nearest to the first strand that it hits. A strand stands at each vertex, and the gap
  /// to its neighbours counts as hit, too. If nothing is hit, the strand nearest to the ray counts, within `beside` of
  /// it.
  std::optional<glm::dvec3> hit_by(const Ray& ray, double beside) const;

  /// 0 where no strand of the coat stands.
  double length(std::uint32_t vertex) const {
    if (lengths_.empty() || (!densities_.empty() && !(densities_[vertex] > 0))) return 0;
    return lengths_[vertex];
  }
  double longest() const { return longest_; }
  /// How many vertices rays have looked at so far (EvaluationCost).
  double visits() const { return visits_; }

 private:
  struct Hit;
  const UnitStrand& strand(std::uint32_t vertex) const;
  Reached nearest(std::uint32_t vertex, glm::dvec3 place) const;
  void intersect(const Ray& ray, std::uint32_t vertex, double beside, Hit& best) const;

  const Surface& surface_;
  const FieldSet& fields_;
  const Coat& coat_;
  const std::vector<float>&lengths_, &densities_;
  double longest_ = 0;
  mutable double visits_ = 0;
  mutable std::unordered_map<std::uint32_t, UnitStrand> strands_;
};

}  // namespace pelage
