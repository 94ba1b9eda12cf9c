// Everything that changes a scene: one struct for each command, with defaults, units and ranges on each field.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "protocol/commands/camera.h"
#include "protocol/commands/coat.h"
#include "protocol/commands/curves.h"
#include "protocol/commands/edit_layer.h"
#include "protocol/commands/eye.h"
#include "protocol/commands/look.h"
#include "protocol/commands/map.h"
#include "protocol/commands/skin.h"
#include "protocol/commands/tools.h"

namespace pelage {

struct SetCoat {
  Coat coat;
};
struct SetLook {
  Look look;
};
struct SetLights {
  std::vector<Light> lights;
};  // at most 8
struct SetEnvironment {
  Environment environment;
};
struct SetGround {
  Ground ground;
};
struct SetEyes {
  std::vector<Eye> eyes;
};  // at most 8
struct SetCurves {
  std::vector<CurveGroup> groups;
};  // at most 16, and 4096 curves in all
struct SetSkin {
  std::vector<SkinRegion> regions;
};  // at most 64

/// Lays a picture on the model by its texture coordinates, in place of all colours of its own. It is named by the 32
/// hex digits that its upload answered with; "" takes it off again.
struct SetSkinTexture {
  std::string picture;
};

/// A plane: a point of it and its normal, model coordinates; the normal is not zero.
struct Plane {
  glm::dvec3 point{0}, normal{1, 0, 0};
};

/// A wind or a stick that stays in the scene under a name, for `blow` and `attract` to use again and again.
struct NamedBlower {
  std::string name;  // 1 to 200 bytes
  Blow blow;         // without stroke, brush and name
};
struct NamedAttractor {
  std::string name;
  Attract attract;
};
struct SetBlowers {
  std::vector<NamedBlower> blowers;
};  // at most 64, names differ
struct SetAttractors {
  std::vector<NamedAttractor> attractors;
};  // at most 64, names differ

/// A tool works on every image of its command under the planes and the rotation, as one undo step.
struct Symmetry {
  std::vector<Plane> planes;  // at most 3; two or more give their combinations
  glm::dvec3 axis_point{0}, axis{0, 1, 0};
  int count = 1;  // of a rotation about the axis, [1, 16]
};
struct SetSymmetry {
  Symmetry symmetry;
};

/// Gives the present revision a name, for `erase` and for comparing.
struct Checkpoint {
  std::string name;                       // 1 to 200 bytes; one that is known moves here
  std::optional<std::uint64_t> revision;  // set when it is resolved
};

using Command = std::variant<Comb, Blow, Attract, Interpolate, Flow, Smooth, Noise, Unify, Part, Length, Trim, Lift,
                             Erase, Clump, Curl, Paint, ChangeMask, ApplyMap, SetBlowers, SetAttractors, SetSymmetry,
                             Checkpoint, ChangeEditLayer, Retarget, SetCoat, SetLook, SetLights, SetEnvironment,
                             SetGround, SetEyes, SetCurves, SetSkin, SetSkinTexture>;

/// The name of the command on the wire: "comb", "set_coat", ...
const char* op_of(const Command& command);

/// The stroke of the command, or null where it has none.
const Stroke* stroke_of(const Command& command);
Stroke* stroke_of(Command& command);

/// The name of the edit layer that keeps what the tool changes; "" for the groom, and for commands that are no tools.
std::string edit_layer_of(const Command& command);

}  // namespace pelage
