// Everything that changes a scene: one struct for each command, with defaults, units and ranges on each field.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "protocol/commands/coat.h"
#include "protocol/commands/creature.h"
#include "protocol/commands/field.h"
#include "protocol/commands/frame.h"
#include "protocol/commands/look.h"
#include "protocol/commands/symmetry.h"
#include "protocol/commands/tool_list.h"
#include "protocol/commands/wind.h"

namespace pelage {

struct SetCoat {
  static constexpr const char* op = "set_coat";
  static constexpr Inputs inputs = Inputs::none;
  Coat coat;
  std::string name = {};  // name of the coat to set; "" for the first
};

/// All coats of a scene, in order. A coat that is left out is removed with its fields.
struct SetCoats {
  static constexpr const char* op = "set_coats";
  static constexpr Inputs inputs = Inputs::none;
  std::vector<CoatEntry> coats;  // 1 to limits::coats
};
struct SetLook {
  static constexpr const char* op = "set_look";
  static constexpr Inputs inputs = Inputs::none;
  Look look;
};
struct SetLights {
  static constexpr const char* op = "set_lights";
  static constexpr Inputs inputs = Inputs::none;
  std::vector<Light> lights;
};  // at most 8
struct SetEnvironment {
  static constexpr const char* op = "set_environment";
  static constexpr Inputs inputs = Inputs::none;
  Environment environment;
};
struct SetGround {
  static constexpr const char* op = "set_ground";
  static constexpr Inputs inputs = Inputs::none;
  Ground ground;
};
struct SetWind {
  static constexpr const char* op = "set_wind";
  static constexpr Inputs inputs = Inputs::none;
  Wind wind;
};
struct SetEyes {
  static constexpr const char* op = "set_eyes";
  static constexpr Inputs inputs = Inputs::placed;
  std::vector<Eye> eyes;
};  // at most 8
struct SetCurves {
  static constexpr const char* op = "set_curves";
  static constexpr Inputs inputs = Inputs::placed;
  std::vector<CurveGroup> groups;
};  // at most 16, and 4096 curves in all
struct SetSkin {
  static constexpr const char* op = "set_skin";
  static constexpr Inputs inputs = Inputs::placed;
  std::vector<SkinRegion> regions;
};  // at most 64

/// Lays a picture on the model by its texture coordinates, in place of the model's own colours. The picture is named by
/// the 32 hex digits that its upload answered with; "" removes it.
struct SetSkinTexture {
  static constexpr const char* op = "set_skin_texture";
  static constexpr Inputs inputs = Inputs::none;
  std::string picture;
};

/// A wind or a stick that is stored in the scene under a name, for `blow` and `attract` to use repeatedly.
struct NamedBlower {
  std::string name;  // 1 to 200 bytes
  Blow blow;         // its stroke, brush and blower are not used
};
struct NamedAttractor {
  std::string name;
  Attract attract;
};
struct SetBlowers {
  static constexpr const char* op = "set_blowers";
  static constexpr Inputs inputs = Inputs::placed;
  std::vector<NamedBlower> blowers;
};  // at most 64, names differ
struct SetAttractors {
  static constexpr const char* op = "set_attractors";
  static constexpr Inputs inputs = Inputs::placed;
  std::vector<NamedAttractor> attractors;
};  // at most 64, names differ

/// The symmetry of commands whose brush has none of its own.
struct SetSymmetry {
  static constexpr const char* op = "set_symmetry";
  static constexpr Inputs inputs = Inputs::placed;
  Symmetry symmetry;
};

/// Gives a revision a name, for `erase` and for comparisons.
struct Checkpoint {
  static constexpr const char* op = "checkpoint";
  static constexpr Inputs inputs = Inputs::none;
  std::string name;                       // 1 to 200 bytes; a known name moves
  std::optional<std::uint64_t> revision;  // none: the revision that this command makes
};

/// Commands that change settings of the scene and do not edit fields themselves.
using Settings =
    CommandList<SetBlowers, SetAttractors, SetSymmetry, Checkpoint, ChangeEditLayer, SetCoat, SetCoats, SetLook,
                SetLights, SetEnvironment, SetGround, SetEyes, SetCurves, SetSkin, SetSkinTexture, SetWind>;

template <class C>
concept SettingCommand = Settings::holds<C>;

template <class... T, class... S>
std::variant<T..., S...> either_of(CommandList<T...>, CommandList<S...>);  // only its return type is used

/// A variant of all commands. It is a class of its own so that copying, moving and destroying it is compiled once, not
/// in each file that does so.
struct Command : decltype(either_of(Tools{}, Settings{})) {
  using variant::variant;
  Command();
  Command(const Command&);
  Command(Command&&) noexcept;
  Command& operator=(const Command&);
  Command& operator=(Command&&) noexcept;
  ~Command();
};

/// The name of the command on the wire: "comb", "set_coat", ...
const char* op_of(const Command& command);

/// The stroke of the command, or null where it has none.
const Stroke* stroke_of(const Command& command);
Stroke* stroke_of(Command& command);

/// Returns the name of the edit layer that takes the tool's change; "" for the groom, and for commands that are no
/// tools.
std::string edit_layer_of(const Command& command);

/// Returns the names of the coats that a tool is restricted to; empty for all coats, and for commands that are no
/// tools.
std::vector<std::string> coats_of(const Command& command);

}  // namespace pelage
