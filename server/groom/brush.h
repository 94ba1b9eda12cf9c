// The brush that all tools share: where a stroke puts its dabs, and how strongly each dab reaches a vertex.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "protocol/commands/command.h"
#include "server/fields/field_set.h"
#include "server/surface/surface.h"

namespace pelage {

/// Weight of a falloff curve at `distance` radii from the middle, in [0, 1]; 0 beyond 1.
double falloff_weight(Falloff curve, double distance);

/// A length of a command in sizes.
double internal_length(double value, Units units, const Mesh& mesh);

/// One print of the brush, in internal coordinates.
struct Dab {
  glm::dvec3 centre{0};
  glm::dvec3 motion{0};  // from the dab before; unit, or 0 where the brush stood still
  double step = 0;       // arc length that it stands for, in radii
  double pressure = 1;
};

/// What one dab does to one vertex: strength x falloff x pressure x mask, in [0, 1].
struct VertexWeight {
  std::uint32_t vertex = 0;
  double weight = 0;
};

/// A stroke as dabs: one for each spacing x radius of arc length and a last one for what is left, so that neither the
/// sampling rate nor the parts that it came in matter. The path between two samples on the surface follows the surface.
class BrushStroke {
 public:
  BrushStroke(const Stroke& stroke, const Brush& brush, const Surface& surface, const FieldSet& fields);

  /// Dabs of a brush that moves; none for a stroke without length or a brush of radius 0.
  std::vector<Dab> moving_dabs() const;
  /// The same, with a dab where the stroke begins: for tools that need no motion.
  std::vector<Dab> covering_dabs() const;
  /// How many dabs the stroke's arc length asks for; may be infinite.
  double dab_count() const;

  /// Vertices that the dab reaches with a weight above 0, in rising order.
  void weigh(const Dab& dab, std::vector<VertexWeight>& weights) const;

 private:
  struct Node {
    glm::dvec3 position;
    double pressure;
    bool on_surface;
  };
  /// Somewhere between two nodes.
  Dab between(const Node& a, const Node& b, double t) const;

  Brush brush_;
  const Surface& surface_;
  const FieldSet& fields_;  // for the mask
  double radius_;  // sizes
  std::vector<Node> path_;
  std::optional<glm::dvec3> eye_;  // what front faces are judged against, where the stroke has a view
};

/// For each vertex under the stroke the largest weight of any dab, in rising order of vertices.
std::vector<VertexWeight> coverage(const Stroke& stroke, const Brush& brush, const Surface& surface,
                                   const FieldSet& fields);

/// Where a tool that visits each vertex once works: under its stroke, or everywhere with `weight`; never where the mask
/// is 0.
std::vector<VertexWeight> reach(const std::optional<Stroke>& stroke, const Brush& brush, double weight,
                                const Surface& surface, const FieldSet& fields);

}  // namespace pelage
