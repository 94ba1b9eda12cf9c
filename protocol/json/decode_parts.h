// Blocks that several documents share: fur, cameras, views, looks, coats, strokes.
#pragma once

#include "protocol/base/limits.h"
#include "protocol/json/ranges.h"
#include "protocol/json/reader.h"

namespace pelage::json_parts {

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
/// 32 hex digits in lower case.
std::string picture_name(const Value& value, const char* limit = "32 hex digits in lower case");
/// Refuses a map of the field in an encoding that cannot hold it.
void refuse_encoding(const Value& value, Field field);
Tracing tracing(const Value& value);
Knobs quality(const Value& value);  // a tier's name, or knobs that start from the interactive tier

}  // namespace pelage::json_parts
