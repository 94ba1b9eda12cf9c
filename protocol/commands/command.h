// Everything that changes a scene: one struct for each command, with defaults, units and ranges on each field.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <glm/glm.hpp>

#include "protocol/commands/camera.h"
#include "protocol/commands/coat.h"
#include "protocol/commands/curves.h"
#include "protocol/commands/eye.h"
#include "protocol/commands/skin.h"
#include "protocol/commands/look.h"

namespace pelage {

enum class Units { relative, world };  // a fraction of the model's size, or its own unit
enum class FalloffShape { volume };    // distance through space
enum class Falloff { constant, linear, smooth, sharp, sphere };

/// Where a stroke passes: a point in the model's coordinates, a pixel of the stroke's view (origin top left, y down,
/// centres at .5), or a place on a triangle.
struct PositionPlace { glm::dvec3 position{0}; };
struct ScreenPlace { glm::dvec2 screen{0}; };
struct SurfacePlace {
  std::uint32_t triangle = 0;
  glm::dvec3 barycentric{1.0 / 3};  // each in [0, 1], sum 1 within 1e-3
};

struct StrokeSample {
  std::variant<PositionPlace, ScreenPlace, SurfacePlace> place;
  double pressure = 1;  // [0, 1]
  double time = 0;      // seconds, [0, 1e6], not falling
};

/// A stroke, whole or a live part. Parts with one `id` join one undo step and give what the whole would have given.
struct Stroke {
  std::string id;            // "" for a stroke sent whole; at most 200 bytes
  std::uint32_t part = 0;    // 0, 1, 2 ... within an id
  bool last = true;
  std::vector<StrokeSample> samples;  // 1 to 10,000
  std::optional<View> view;  // required by pixel samples; front faces are then judged against it
};

/// The brush block that all tools share.
struct Brush {
  double radius = 0.05;  // in `units`, [0, 1e6 sizes]
  Units units = Units::relative;
  FalloffShape falloff_shape = FalloffShape::volume;
  Falloff falloff = Falloff::smooth;
  double strength = 0.8;         // [0, 1]
  double spacing = 0.25;         // of a dab, in radii, [0.01, 10]
  bool front_faces_only = true;  // against the view of pixel samples, else the surface normal at the sample
  bool invert = false;           // the tool's opposite
};

/// Turns fur the way the stroke moves (science.md 3). As a flood it needs a direction.
struct Comb {
  std::optional<Stroke> stroke;
  bool flood = false;
  Brush brush;
  double lean = 0.7;                     // inclination that combing tends to, [0, 1]
  std::optional<glm::dvec3> direction;   // flood only: where the fur is combed to; not zero
};

/// Wind from a source, inside a cone; a stroke restricts it to what its brush covers.
struct Blow {
  std::optional<Stroke> stroke;
  Brush brush;
  glm::dvec3 source{0};         // model coordinates
  glm::dvec3 direction{0, -1, 0};  // axis of the cone; not zero
  double cone_degrees = 40;     // half angle, [0, 180]
  double softness = 0.25;       // share of the cone over which the edge fades, [0, 1]
  double strength = 0.5;        // [0, 1]
  double lean = 0.7;            // inclination that the wind tends to, [0, 1]
};

/// A stick that pulls fur to it and stretches it (fur modelling 5.2); a stroke restricts it to what its brush covers.
struct Attract {
  std::optional<Stroke> stroke;
  Brush brush;
  glm::dvec3 point{0};     // model coordinates
  double radius = 0.2;     // in `units`, [0, 1e6 sizes]
  Units units = Units::relative;
  double strength = 0.5;   // [0, 1]
  double duration = 1;     // seconds of pulling, [0, 1e4]
  double threshold = 0.3;  // stretch that fur takes without growing, [0, 1e3]
  double max_stretch = 3;  // largest length over the length before any stretch, [1, 100]
};

struct SetCoat { Coat coat; };
struct SetLook { Look look; };
struct SetLights { std::vector<Light> lights; };  // at most 8
struct SetEnvironment { Environment environment; };
struct SetGround { Ground ground; };
struct SetEyes { std::vector<Eye> eyes; };        // at most 8
struct SetCurves { std::vector<CurveGroup> groups; };  // at most 16, and 4096 curves in all
struct SetSkin { std::vector<SkinRegion> regions; };  // at most 64

/// Lays a picture on the model by its texture coordinates, in place of all colours of its own. It is named by the 32
/// hex digits that its upload answered with; "" takes it off again.
struct SetBasePicture {
  std::string picture;
};

using Command = std::variant<Comb, Blow, Attract, SetCoat, SetLook, SetLights, SetEnvironment, SetGround, SetEyes,
                             SetCurves, SetSkin, SetBasePicture>;

/// The name of the command on the wire: "comb", "set_coat", ...
const char* op_of(const Command& command);

/// The stroke of the command, or null where it has none.
const Stroke* stroke_of(const Command& command);
Stroke* stroke_of(Command& command);

}  // namespace pelage
