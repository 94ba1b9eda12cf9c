// Blocks that several documents share: fur, cameras, views, looks, coats, strokes.
#pragma once

#include "protocol/base/limits.h"
#include "protocol/json/reader.h"

namespace pelage::json_parts {

// The largest model has a size of about 3.5e20, and commands reach 1e6 sizes; the scene checks the sizes exactly.
inline constexpr Range coordinate{-1e27, 1e27};
inline constexpr Range length_in_units{0, 1e27};
inline constexpr Range share{0, 1};
inline constexpr Range clump_size{0.001, 0.5};
inline constexpr Range feature_size{0.005, 2};
inline constexpr Range pixels{1, limits::frame_pixels};

Camera camera(const Value& value);
View view(const Value& value);
Look look(const Value& value);
Coat coat(const Value& value);
Light light(const Value& value);
Environment environment(const Value& value);
Ground ground(const Value& value);
Eye eye(const Value& value);
std::vector<CurveGroup> curve_groups(const Value& list);
SkinRegion skin_region(const Value& value);
Brush brush(const Value& value);
Stroke stroke(const Value& value);
FirstGroom fur(const Value& value);
Knobs quality(const Value& value);  // a tier's name, or knobs that start from the interactive tier

}  // namespace pelage::json_parts
