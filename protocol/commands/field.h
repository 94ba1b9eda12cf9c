// The fields on a model's surface, each with its unit and range, and the edit layers that change them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "protocol/commands/inputs.h"

namespace pelage {

enum class Field : std::uint8_t {
  direction,    // lean in the vertex's (tangent, bitangent); its length is the inclination, [0, 1]
  length,       // sizes
  stretch,      // stretch that attract has built up
  density,      // share of the coat's strands that grow here
  width,        // factor on the coat's strand widths
  curl,         // added to the coat's own
  clump,        // added to the coat's own
  wetness,      // added to the coat's own
  bare,         // 1 where skin shows
  mask,         // how much tools may change: 1 all, 0 nothing
  root_colour,  // linear red, green, blue, and how much of the coat's colour they cover
  tip_colour,   // the same at the tips
  stiffness,    // stiffness in the wind: 2 leans half as far; last, because journals store the numbers
};

struct FieldShape {
  std::string_view name;    // on the wire
  int channels = 1;         // [1, 4]
  float default_value = 0;  // first value of every channel
  float min = 0, max = 1;
};

inline constexpr std::array<FieldShape, 13> field_shapes{{{"direction", 2, 0, -1, 1},
                                                          {"length", 1, 0, 0, 10},
                                                          {"stretch", 1, 0, 0, 1e7f},
                                                          {"density", 1, 1, 0, 1},
                                                          {"width", 1, 1, 0, 4},
                                                          {"curl", 1, 0, 0, 1},
                                                          {"clump", 1, 0, 0, 1},
                                                          {"wetness", 1, 0, 0, 1},
                                                          {"bare", 1, 0, 0, 1},
                                                          {"mask", 1, 1, 0, 1},
                                                          {"root_colour", 4, 0, 0, 1},
                                                          {"tip_colour", 4, 0, 0, 1},
                                                          {"stiffness", 1, 1, 0, 4}}};

inline constexpr std::size_t field_count = field_shapes.size();
/// The painted fields are this one and all after it.
inline constexpr std::size_t first_painted = static_cast<std::size_t>(Field::density);

/// Returns whether all coats of a scene share the field; each coat has its own of the other fields.
constexpr bool is_shared(Field field) { return field == Field::bare || field == Field::mask; }

constexpr const FieldShape& shape_of(Field field) { return field_shapes[static_cast<std::size_t>(field)]; }
constexpr Field field_at(std::size_t number) { return static_cast<Field>(number); }

// Edit layers: changes of a groom that are stored apart from it, so that they can be weighted, muted and removed.

/// A set of changes that is stored apart from the groom below. The visible value is the groom plus, edit layer by edit
/// layer, the weight times what the edit layer adds, clamped to the field's range. The mask belongs to no edit layer.
struct EditLayer {
  std::string name = {};  // 1 to 200 bytes; names differ
  double weight = 1;      // [-4, 4]; below 0 it reverses the change
  bool muted = false;
  std::string coat = {};  // name of the only coat whose changes it stores; "" for all coats
  bool operator==(const EditLayer&) const = default;
};

/// add: adds an edit layer. set: changes its weight, mute or name. move: changes its position among the edit layers.
/// merge_down: merges it into the edit layer below or, if it is the lowest, into the groom; neither may be muted.
/// remove: removes it with its contents.
enum class EditLayerAction { add, set, move, merge_down, remove };
struct ChangeEditLayer {
  static constexpr const char* op = "edit_layer";
  static constexpr Inputs inputs = Inputs::none;
  EditLayerAction action = EditLayerAction::add;
  std::string name = {};                  // 1 to 200 bytes
  std::optional<double> weight = {};      // for add and set
  std::optional<bool> muted = {};         // for add and set
  std::optional<std::string> coat = {};   // for add: EditLayer::coat
  std::string rename = {};                // for set: the new name; "" keeps the old one
  std::optional<std::string> above = {};  // for add, move: layer directly below it, "" for the bottom; absent: on top
};

}  // namespace pelage
