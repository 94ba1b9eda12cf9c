// The brush that all tools share: the positions of a stroke's dabs, and the weight of each dab at a vertex.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "protocol/commands/command.h"
#include "server/groom/evaluate.h"
#include "server/groom/standing_fur.h"
#include "server/surface/surface.h"

namespace pelage {

/// Returns the weight of a falloff curve at `distance` radii from the middle, in [0, 1]; 0 beyond 1.
double falloff_weight(Falloff curve, double distance);
/// Returns the weight of a brush's falloff: its points, interpolated linearly, or the curve that it names.
double falloff_weight(const Brush& brush, double distance);

/// Returns the standing fur if the brush reaches for fur; nothing if it reaches for skin.
std::optional<StandingFur> fur_reached(const Brush& brush, const Surface& surface, const FieldSet& fields,
                                       const Coat& coat);

/// Returns the brush of a tool; null for commands that have none.
const Brush* brush_of(const Command& command);
Brush* brush_of(Command& command);

/// Converts a length of a command to sizes.
double internal_length(double value, Units units, const Mesh& mesh);
inline std::optional<double> internal_length(std::optional<double> value, Units units, const Mesh& mesh) {
  return value ? std::optional(internal_length(*value, units, mesh)) : std::nullopt;
}

/// One imprint of the brush, in internal coordinates.
struct Dab {
  glm::dvec3 centre{0};
  glm::dvec3 motion{0};  // unit vector from the previous dab (the first: to the next); 0 if the brush stood still
  double step = 0;       // arc length of the stroke that the dab covers, in radii
  double pressure = 1;
  double radius = 0;  // sizes
};

/// The weight of one dab at one vertex: strength x falloff x pressure, in [0, 1]. The mask is not included.
struct VertexWeight {
  std::uint32_t vertex = 0;
  double weight = 0;
};

/// A stroke as dabs: one for each arc length of spacing x radius, and one for the remainder, so that the result does
/// not depend on the sampling rate or on the parts in which the stroke arrived. The path between two samples on the
/// surface follows the surface.
class BrushStroke {
 public:
  /// `fur` is required for a brush that reaches for fur, `alpha` for one that names an alpha picture; both must outlive
  /// the stroke.
  BrushStroke(const Stroke& stroke, const Brush& brush, const Surface& surface, const StandingFur* fur = nullptr,
              const MapPicture* alpha = nullptr);

  /// Returns dabs with a motion; none for a stroke without length or a brush of radius 0.
  std::vector<Dab> moving_dabs() const;
  /// Returns moving_dabs() preceded by a dab at the beginning of the stroke, for tools that need no motion.
  std::vector<Dab> covering_dabs() const;
  /// Returns the number of dabs along the stroke's arc length; may be infinite.
  double dab_count() const;
  /// Radius at the first sample, in sizes; it determines the distance between dabs.
  double radius() const { return radius_; }

  /// Returns the brush radius at a position, in sizes. A radius in pixels grows with the distance to the camera.
  double radius_at(glm::dvec3 position) const;

  /// Collects the vertices at which the dab has a weight above 0, sorted. The cost depends on their number, not on the
  /// mesh, except for the screen shape, which tests every vertex.
  void weigh(const Dab& dab, std::vector<VertexWeight>& weights) const;

 private:
  struct Node {
    glm::dvec3 position;
    double pressure;
    bool on_surface;
  };
  struct Reached {
    std::uint32_t vertex;
    double distance;  // radii
    double lift = 0;  // height above the skin of the strand's nearest point, in strand lengths
  };
  /// Returns the dab at parameter `t` in [0, 1] between two nodes.
  Dab between(const Node& a, const Node& b, double t) const;
  void reach_fur(const Dab& dab, std::vector<Reached>& reached) const;
  void reach_through_space(const Dab& dab, std::vector<Reached>& reached) const;
  void reach_along_surface(const Dab& dab, std::vector<Reached>& reached) const;
  void reach_on_screen(const Dab& dab, std::vector<Reached>& reached) const;

  Brush brush_;
  const Surface& surface_;
  const StandingFur* fur_;
  const MapPicture* alpha_;
  std::vector<Node> path_;
  std::optional<PlacedCamera> camera_;  // of the stroke's view, for the front-facing test and for radii in pixels
  int view_height_ = 1;                 // pixels
  double radius_ = 0;
};

/// Returns the point nearest to `position` on the polyline of the stroke's samples, in internal coordinates.
glm::dvec3 nearest_on_path(const Stroke& stroke, const Surface& surface, glm::dvec3 position);

// The vertices and weights of tools that visit each vertex once.

enum class Masked { yes, no };

/// Returns the vertices with weights above 0, sorted: under a stroke the largest weight of any dab, without a stroke
/// the brush's strength everywhere. The weights are multiplied by the mask, unless the mask itself is painted. Throws
/// Cancelled.
std::vector<VertexWeight> region_of(const std::optional<Stroke>& stroke, const Brush& brush, const Surface& surface,
                                    const FieldSet& fields, const ToolExtras& extras, Masked masked = Masked::yes);

/// Returns the share of a field that lies in the part of the strand that the brush changes, [0, 1]. The root colour
/// covers the lower half of the strand, the tip colour the upper half; other fields have one value for the whole
/// strand: 1.
double strand_share(const Brush& brush, Field field);

}  // namespace pelage
