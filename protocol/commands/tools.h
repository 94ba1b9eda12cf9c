// Commands that change the fields. Each works under a stroke's brush or, as a flood, everywhere; the mask applies to
// all. A tool works on the visible values. `edit_layer` names the edit layer that stores its change; "" for the groom
// below them all. `coats` names the coats that it works on; empty for all that are not muted.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "protocol/commands/field.h"
#include "protocol/commands/inputs.h"
#include "protocol/commands/scene.h"
#include "protocol/commands/stroke.h"

namespace pelage {

/// Turns fur in the direction in which the stroke moves (science.md 3). A flood needs a direction.
struct Comb {
  static constexpr const char* op = "comb";
  static constexpr Inputs inputs = Inputs::placed;
  static constexpr Work work = Work::vertices;
  static constexpr Opposite opposite = Opposite::yes;
  std::optional<Stroke> stroke = {};
  bool flood = false;
  Brush brush = {};
  std::string edit_layer = {};
  std::vector<std::string> coats = {};
  double lean = 0.7;                         // inclination that combing tends to, [0, 1]
  bool keep_inclination = false;             // changes only the heading
  std::optional<glm::dvec3> direction = {};  // flood only: direction to comb in; not zero
};

/// Wind from a source, inside a cone; a stroke restricts it to the region of its brush.
struct Blow {
  static constexpr const char* op = "blow";
  static constexpr Inputs inputs = Inputs::placed;
  static constexpr Work work = Work::vertices;
  static constexpr Opposite opposite = Opposite::yes;
  std::optional<Stroke> stroke = {};
  Brush brush = {};
  std::string edit_layer = {};
  std::vector<std::string> coats = {};
  std::string blower = {};         // name of a stored wind (set_blowers) that replaces the settings below; "" for none
  glm::dvec3 source{0};            // model coordinates
  glm::dvec3 direction{0, -1, 0};  // axis of the cone; not zero
  double cone_degrees = 40;        // half angle, [0, 180]
  double softness = 0.25;          // share of the cone over which the edge fades, [0, 1]
  double fall = 0;                 // distance at which the wind has half its strength, in `units`; 0: no falloff
  Units units = Units::relative;
  double strength = 0.5;  // [0, 1]
  double lean = 0.7;      // inclination that the wind tends to, [0, 1]
};

/// A stick that pulls fur to it and stretches it (fur modelling 5.2); a stroke restricts it to the region of its brush.
struct Attract {
  static constexpr const char* op = "attract";
  static constexpr Inputs inputs = Inputs::placed;
  static constexpr Work work = Work::vertices;
  static constexpr Opposite opposite = Opposite::yes;
  std::optional<Stroke> stroke = {};
  Brush brush = {};
  std::string edit_layer = {};
  std::vector<std::string> coats = {};
  std::string attractor = {};  // name of a stored stick (set_attractors) that replaces the settings below; "" for none
  glm::dvec3 point{0};         // model coordinates
  double radius = 0.2;         // in `units`, [0, 1e6 sizes]
  Units units = Units::relative;
  double strength = 0.5;   // [0, 1]
  double duration = 1;     // seconds of pulling, [0, 1e4]
  double threshold = 0.3;  // stretch that fur takes without growing, [0, 1e3]
  double max_stretch = 3;  // largest length over the length before any stretch, [1, 100]
};

enum class DistanceKind { straight, dijkstra, heat };  // through space; along edges; along the surface (heat method)

/// What the fur should be like at one position.
struct Key {
  glm::dvec3 position{0};                    // model coordinates; moved to the nearest point of the surface
  std::optional<glm::dvec3> direction = {};  // direction in which fur leans; not zero
  std::optional<double> inclination = {};    // [0, 1]; only with a direction; absent: .5
  std::optional<double> length = {};         // in the command's `units`, [0, 10 sizes]
};

/// Spreads keys over the surface with Gaussian weights of the distance (fur modelling 5.1).
struct Interpolate {
  static constexpr const char* op = "interpolate";
  static constexpr Inputs inputs = Inputs::placed;
  static constexpr Work work = Work::own;
  static constexpr Opposite opposite = Opposite::no;
  std::optional<Stroke> stroke = {};  // restricts it to what its brush covers
  Brush brush = {};
  std::string edit_layer = {};
  std::vector<std::string> coats = {};
  std::vector<Key> keys = {};        // 1 to 1,024
  double sigma = 0.2;                // width of the Gaussians, in `units`, above 0
  std::optional<double> reach = {};  // distance beyond which nothing changes, in `units`, above 0; absent: no limit
  Units units = Units::relative;
  DistanceKind distance = DistanceKind::dijkstra;
  double strength = 1;  // [0, 1]
};

/// Lays the fur of the whole body along curves that are drawn on it.
struct Flow {
  static constexpr const char* op = "flow";
  static constexpr Inputs inputs = Inputs::placed;
  static constexpr Work work = Work::own;
  static constexpr Opposite opposite = Opposite::no;
  std::optional<Stroke> stroke = {};  // restricts it to what its brush covers
  Brush brush = {};
  std::string edit_layer = {};
  std::vector<std::string> coats = {};
  std::vector<std::vector<glm::dvec3>> curves =
      {};                            // 1 to 64, of 2 to 256 points in model coordinates, root to tip of the flow
  double sigma = 0.2;                // width of the Gaussians, in `units`, above 0
  std::optional<double> reach = {};  // as Interpolate::reach
  Units units = Units::relative;
  DistanceKind distance = DistanceKind::dijkstra;
  std::optional<double> inclination = {};  // [0, 1]; absent: unchanged
  double strength = 1;                     // [0, 1]
};

/// V' = (1 - t) V + t sum w_j V_j over neighbours, w_j the inverse distance, normalised (fur modelling 5.1).
struct Smooth {
  static constexpr const char* op = "smooth";
  static constexpr Inputs inputs = Inputs::none;
  static constexpr Work work = Work::own;
  static constexpr Opposite opposite = Opposite::no;
  std::optional<Stroke> stroke = {};
  bool flood = false;
  Brush brush = {};
  std::string edit_layer = {};
  std::vector<std::string> coats = {};
  double t = 0.5;  // [0, 1]
  int passes = 3;  // [1, 10,000]
  bool keep_inclination = false;
  std::vector<Field> fields{Field::direction};
};

/// Adds seeded noise (fur modelling 5.1: disturb).
struct Noise {
  static constexpr const char* op = "noise";
  static constexpr Inputs inputs = Inputs::placed;
  static constexpr Work work = Work::vertices;
  static constexpr Opposite opposite = Opposite::yes;
  std::optional<Stroke> stroke = {};
  bool flood = false;
  Brush brush = {};
  std::string edit_layer = {};
  std::vector<std::string> coats = {};
  std::uint32_t seed = 1;
  double amount = 0.2;      // [0, 10]: inclinations; shares of length, stretch, width, stiffness; others in their unit
  double feature_size = 0;  // feature size of the noise, in `units`; 0: independent at each vertex
  Units units = Units::relative;
  std::vector<Field> fields{Field::direction};
};

/// Blends to a value, or to the mean under the brush (fur modelling 5.1).
struct Unify {
  static constexpr const char* op = "unify";
  static constexpr Inputs inputs = Inputs::placed;
  static constexpr Work work = Work::vertices;
  static constexpr Opposite opposite = Opposite::no;
  std::optional<Stroke> stroke = {};
  bool flood = false;
  Brush brush = {};
  std::string edit_layer = {};
  std::vector<std::string> coats = {};
  std::optional<glm::dvec3> direction = {};  // not zero
  std::optional<double> inclination = {};    // [0, 1]
  std::optional<double> length = {};         // in `units`
  Units units = Units::relative;
  std::vector<Field> mean = {};  // fields that are blended to their weighted mean
  double weight = 0.5;           // [0, 1], factor on the brush's strength
};

/// A line that fur leans away from on both sides.
struct Part {
  static constexpr const char* op = "part";
  static constexpr Inputs inputs = Inputs::none;
  static constexpr Work work = Work::vertices_x_samples;
  static constexpr Opposite opposite = Opposite::yes;
  static constexpr bool needs_stroke = true;
  std::optional<Stroke> stroke = {};  // the line; required
  Brush brush = {};
  std::string edit_layer = {};
  std::vector<std::string> coats = {};
  double lean = 0.7;  // [0, 1]
};

/// Turns fur around the nearest point of the stroke: one sample makes a cowlick, a line makes two opposite currents.
struct Whorl {
  static constexpr const char* op = "whorl";
  static constexpr Inputs inputs = Inputs::none;
  static constexpr Work work = Work::vertices_x_samples;
  static constexpr Opposite opposite = Opposite::yes;
  static constexpr bool needs_stroke = true;
  std::optional<Stroke> stroke = {};  // centre of the whorl; required
  Brush brush = {};
  std::string edit_layer = {};
  std::vector<std::string> coats = {};
  double turn_degrees = 70;  // angle from outwards, counter-clockwise seen from outside, [-180, 180]: 90 circles
  double lean = 0.8;         // inclination that fur tends to, [0, 1]
};

enum class LengthMode { set, add, scale, average, jitter, min, max };
struct Length {
  static constexpr const char* op = "length";
  static constexpr Inputs inputs = Inputs::placed;
  static constexpr Work work = Work::vertices;
  static constexpr Opposite opposite = Opposite::yes;
  std::optional<Stroke> stroke = {};
  bool flood = false;
  Brush brush = {};
  std::string edit_layer = {};
  std::vector<std::string> coats = {};
  LengthMode mode = LengthMode::set;
  double value = 0.03;  // a length in `units` (may be below 0 for add), a factor, or the share of a jitter
  Units units = Units::relative;
  std::uint32_t seed = 1;  // for a jitter
};

struct TrimPlane {
  glm::dvec3 point{0}, normal{0, 1, 0};
};  // cuts fur on the side that the normal points to
struct TrimSphere {
  glm::dvec3 centre{0};
  double radius = 0;
  bool keep_inside = true;
};  // radius in `units`
/// Cuts fur by a plane, by a sphere, or to a height over the skin.
struct Trim {
  static constexpr const char* op = "trim";
  static constexpr Inputs inputs = Inputs::placed;
  static constexpr Work work = Work::vertices;
  static constexpr Opposite opposite = Opposite::no;
  std::optional<Stroke> stroke = {};
  bool flood = false;
  Brush brush = {};
  std::string edit_layer = {};
  std::vector<std::string> coats = {};
  std::variant<TrimPlane, TrimSphere, double> shape{0.01};  // a height in `units`
  Units units = Units::relative;
};

/// Raises fur; inverted it lays it down. Fur that stands upright has no heading to be laid along and stays.
struct Lift {
  static constexpr const char* op = "lift";
  static constexpr Inputs inputs = Inputs::none;
  static constexpr Work work = Work::vertices;
  static constexpr Opposite opposite = Opposite::yes;
  std::optional<Stroke> stroke = {};
  bool flood = false;
  Brush brush = {};
  std::string edit_layer = {};
  std::vector<std::string> coats = {};
};

/// Restores the first groom, or a checkpoint or revision of this scene. With an edit layer and neither of them, removes
/// what the edit layer adds.
struct Erase {
  static constexpr const char* op = "erase";
  static constexpr Inputs inputs = Inputs::none;
  static constexpr Work work = Work::vertices;
  static constexpr Opposite opposite = Opposite::no;
  std::optional<Stroke> stroke = {};
  bool flood = false;
  Brush brush = {};
  std::string edit_layer = {};
  std::vector<std::string> coats = {};
  std::string checkpoint = {};                 // "" for none
  std::optional<std::uint64_t> revision = {};  // revision of this model to restore; absent for none
  std::vector<Field> fields = {};              // empty for all except the mask
};

/// Turns fur to the middle of the brush, and gathers tips to locks.
struct Clump {
  static constexpr const char* op = "clump";
  static constexpr Inputs inputs = Inputs::none;
  static constexpr Work work = Work::vertices_x_samples;
  static constexpr Opposite opposite = Opposite::yes;
  static constexpr bool needs_stroke = true;
  std::optional<Stroke> stroke = {};  // required
  Brush brush = {};
  std::string edit_layer = {};
  std::vector<std::string> coats = {};
  double gather = 0.3;  // how far fur turns to the middle of each dab, [0, 1]
  double amount = 0.6;  // value that the field clump tends to, [0, 1]
};

/// Curls fur and turns its heading.
struct Curl {
  static constexpr const char* op = "curl";
  static constexpr Inputs inputs = Inputs::none;
  static constexpr Work work = Work::vertices;
  static constexpr Opposite opposite = Opposite::yes;
  std::optional<Stroke> stroke = {};
  bool flood = false;
  Brush brush = {};
  std::string edit_layer = {};
  std::vector<std::string> coats = {};
  double amount = 0.6;      // value that the field curl tends to, [0, 1]
  double turn_degrees = 0;  // counter-clockwise seen from outside, [-180, 180]
};

/// Paints a field: value or colour.
struct Paint {
  static constexpr const char* op = "paint";
  static constexpr Inputs inputs = Inputs::none;
  static constexpr Work work = Work::vertices;
  static constexpr Opposite opposite = Opposite::yes;
  std::optional<Stroke> stroke = {};
  bool flood = false;
  Brush brush = {};
  std::string edit_layer = {};
  std::vector<std::string> coats = {};
  Field field = Field::density;  // any field except direction, length and stretch
  double value = 1;              // in the field's range; for a colour its coverage, [0, 1]
  glm::vec3 colour{1};           // linear; for colour fields
};

/// Takes the fields of another scene, or of this one at another revision, from the nearest positions on its surface.
/// Lengths stay shares of the size or, without alignment, keep their value in the models' unit.
struct Retarget {
  static constexpr const char* op = "retarget";
  static constexpr Inputs inputs = Inputs::none;
  static constexpr Work work = Work::own;
  std::string scene = {};                      // id of the source, on the same server
  std::optional<std::uint64_t> revision = {};  // revision of the source's model; set when the command is resolved
  Alignment align = Alignment::box;
  std::vector<Field> fields = {};  // empty for all except the mask
  double strength = 1;             // [0, 1]
  std::string edit_layer = {};
  std::vector<std::string> coats = {};
};

enum class MaskAction { select, grow, shrink, smooth, invert };
enum class MaskCombine { replace, add, subtract, intersect };
struct MaskAll {};
struct MaskVertices {
  std::vector<std::uint32_t> vertices = {};
};  // 1 to 100,000
struct MaskBox {
  glm::dvec3 min{0}, max{0};
};  // model coordinates
struct MaskSphere {
  glm::dvec3 centre{0};
  double radius = 0.1;
  double softness = 0;
};  // radius in `units`; softness: share of the radius over which it fades
struct MaskPart {
  glm::dvec3 position{0};
};  // the connected part nearest to it
struct MaskMaterial {
  std::string name = {};
};  // name of a material of the model's report
enum class PictureChannel {
  luminance,
  red,
  green,
  blue,
  alpha
};  // luminance: Rec. 709 weights of the numbers in the file
/// Takes the mask from an uploaded picture, at the vertices' texture coordinates.
struct MaskPicture {
  std::string name = {};
  PictureChannel channel = PictureChannel::luminance;
};  // name: 32 hex digits
/// Changes the mask, which selects where tools work. `paint` brushes it.
struct ChangeMask {
  static constexpr const char* op = "mask";
  static constexpr Inputs inputs = Inputs::placed;
  static constexpr Work work = Work::own;
  MaskAction action = MaskAction::select;
  std::variant<MaskAll, MaskVertices, MaskBox, MaskSphere, MaskPart, MaskMaterial, MaskPicture> shape =
      {};                                      // for select
  MaskCombine combine = MaskCombine::replace;  // for select
  double value = 1;        // for select: value of what is chosen, [0, 1]; with replace, the others get 1 - value
  double distance = 0.02;  // for grow and shrink: along edges of the mesh, in `units`
  Units units = Units::relative;
  int passes = 3;  // for smooth, [1, 10,000]
};

}  // namespace pelage
