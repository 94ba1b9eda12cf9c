// JSON Schema of values: numbers, texts, lists, and the shapes that members of several structs share.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <string>

#include "base/limits.h"
#include "protocol/json/ranges.h"
#include "protocol/json/write.h"

namespace pelage::json_parts {

/// Returns a reference to a schema of the contract.
Json reference(const std::string& name);
/// Adds a description to a schema, unless there are no words.
Json described(Json schema, const char* words);

Json number_schema(const char* type, Range range);
Json text_schema(std::size_t min, std::size_t max = limits::name_bytes);
Json list_schema(Json items, Count count);
/// Returns the rule that a tool takes either a stroke or a flood.
Json stroke_or_flood();
/// Returns the schemas that members of several structs refer to, by their names.
Json shapes();

// Default values.

/// Both write whole numbers without a point, and floats with the fewest digits that identify them.
Json plain_number(double value);
Json plain_number(float value);
template <class Vector>
Json plain_list(const Vector& vector) {
  Json values = Json::array();
  for (int i = 0; i < Vector::length(); ++i) values.push_back(plain_number(vector[i]));
  return values;
}
/// Returns a linear colour as text if that has the same value, and otherwise as a list.
Json colour_default(glm::vec3 linear);

}  // namespace pelage::json_parts
