// The fields on a model's surface: what each holds, in which unit and range.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace pelage {

enum class Field : std::uint8_t {
  direction,    // where fur leans in the vertex's (tangent, bitangent); its length is the inclination, [0, 1]
  length,       // sizes
  stretch,      // what the attracting stick has built up
  density,      // share of the coat's strands that stand here
  width,        // of the coat's strand widths
  curl,         // added to the coat's own
  clump,        // added to the coat's own
  wetness,      // added to the coat's own
  bare,         // 1 where skin shows
  mask,         // how much tools may change: 1 all, 0 nothing
  root_colour,  // linear red, green, blue, and how much of the coat's colour they cover
  tip_colour,   // the same at the tips
};

struct FieldShape {
  std::string_view name;    // on the wire
  int channels = 1;         // [1, 4]
  float default_value = 0;  // what every channel holds before anything has touched it
  float min = 0, max = 1;
};

inline constexpr std::array<FieldShape, 12> field_shapes{{{"direction", 2, 0, -1, 1},
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
                                                          {"tip_colour", 4, 0, 0, 1}}};

inline constexpr std::size_t field_count = field_shapes.size();
inline constexpr std::size_t first_painted = static_cast<std::size_t>(Field::density);  // and all after it

constexpr const FieldShape& shape_of(Field field) { return field_shapes[static_cast<std::size_t>(field)]; }
constexpr Field field_at(std::size_t number) { return static_cast<Field>(number); }

}  // namespace pelage
