// The brush that all tools share: where a stroke puts its dabs, and how strongly each dab reaches a vertex.
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

/// Weight of a falloff curve at `distance` radii from the middle, in [0, 1]; 0 beyond 1.
double falloff_weight(Falloff curve, double distance);
/// Weight of a brush's own falloff: its points, straight between them, or the curve that it names.
double falloff_weight(const Brush& brush, double distance);

/// Returns the standing fur if the brush reaches for fur; else nothing.
std::optional<StandingFur> fur_reached(const Brush& brush, const Surface& surface, const FieldSet& fields,
                                       const Coat& coat);

/// The brush of a tool; null for commands that have none.
const Brush* brush_of(const Command& command);
Brush* brush_of(Command& command);

/// Converts a length of a command to sizes.
double internal_length(double value, Units units, const Mesh& mesh);
inline std::optional<double> internal_length(std::optional<double> value, Units units, const Mesh& mesh) {
  return value ? std::optional(internal_length(*value, units, mesh)) : std::nullopt;
}

/// One print of the brush, in internal coordinates.
struct Dab {
  glm::dvec3 centre{0};
  glm::dvec3 motion{0};  // from the dab before, of the first one to the next; unit, or 0 where the brush stood still
  double step = 0;       // arc length that it stands for, in radii
  double pressure = 1;
  double radius = 0;  // sizes
};

/// What one dab does to one vertex: strength x falloff x pressure, in [0, 1]. The mask is not in it.
struct VertexWeight {
  std::uint32_t vertex = 0;
  double weight = 0;
};

/// A stroke as dabs: one for each spacing x radius of arc length and a last one for what is left, so that neither the
/// sampling rate nor the parts that it came in matter. The path between two samples on the surface follows the surface.
class BrushStroke {
 public:
  /// `fur` is what a brush reaches that does not reach for skin, `alpha` the picture that the brush names; both outlive
  /// the stroke.
  BrushStroke(const Stroke& stroke, const Brush& brush, const Surface& surface, const StandingFur* fur = nullptr,
              const MapPicture* alpha = nullptr);

  /// Dabs of a brush that moves; none for a stroke without length or a brush of radius 0.
  std::vector<Dab> moving_dabs() const;
  /// The same, with a dab where the stroke begins: for tools that need no motion.
  std::vector<Dab> covering_dabs() const;
  /// How many dabs the stroke's arc length asks for; may be infinite.
  double dab_count() const;
  /// Radius at the first sample, sizes; the step from dab to dab follows from it.
  double radius() const { return radius_; }

  /// How wide it is at a place; in pixels it grows with the distance to the camera.
  double radius_at(glm::dvec3 place) const;

  /// Vertices that the dab reaches with a weight above 0, in rising order. Cost follows their number, not the mesh,
  /// but for the screen shape, which looks at every vertex.
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
    double lift = 0;  // height over the skin of the strand's nearest point, in its lengths
  };
  /// Somewhere between two nodes.
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
  std::optional<PlacedCamera> camera_;  // of the stroke's view: front faces are judged from its position
  int view_height_ = 1;                 // pixels
  double radius_ = 0;
};

/// The nearest point to `position` of the stroke's path from sample to sample, internal coordinates.
glm::dvec3 nearest_on_path(const Stroke& stroke, const Surface& surface, glm::dvec3 position);

// Where a tool that visits each vertex once works, and how strongly.

enum class Masked { yes, no };

/// Returns the vertices with weights above 0, rising: under a stroke the largest weight of any dab, without one the
/// brush's strength everywhere. The weights are multiplied by the mask, unless the mask itself is painted. Throws
/// Cancelled.
std::vector<VertexWeight> region_of(const std::optional<Stroke>& stroke, const Brush& brush, const Surface& surface,
                                    const FieldSet& fields, const ToolExtras& extras, Masked masked = Masked::yes);

/// Returns how much of a field lies in the part of the strand that the brush changes. The root colour stands for the
/// lower half, the tip colour for the upper half; other fields have one value for the whole strand: 1.
double strand_share(const Brush& brush, Field field);

}  // namespace pelage
