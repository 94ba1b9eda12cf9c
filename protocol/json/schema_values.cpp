#include "protocol/json/schema_values.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

#include "protocol/json/colour.h"

namespace pelage::json_parts {

Json reference(const std::string& name) { return {{"$ref", "#/components/schemas/" + name}}; }

Json plain_number(double value) {
  if (value == std::floor(value) && std::abs(value) < 1e15) return static_cast<std::int64_t>(value);
  return value;
}

Json plain_number(float value) {
  char text[32];
  const char* end = std::to_chars(text, text + sizeof text, value).ptr;
  double number = 0;
  std::from_chars(text, end, number);
  return plain_number(number);
}

Json colour_default(glm::vec3 linear) {
  if (const auto text = text_of_colour(linear)) return *text;
  return plain_list(linear);
}

Json number_schema(const char* type, Range range) {
  Json schema = {{"type", type}};
  if (range.low == positive.low)
    schema["exclusiveMinimum"] = 0;
  else if (range.low != any_number.low)
    schema["minimum"] = plain_number(range.low);
  if (range.high != any_number.high) schema["maximum"] = plain_number(range.high);
  if (*range.unit) schema["x-unit"] = range.unit;
  return schema;
}

Json list_schema(Json items, Count count) {
  Json schema = {{"type", "array"}, {"items", std::move(items)}};
  if (count.max == any_count.max) return schema;
  schema["minItems"] = count.min, schema["maxItems"] = count.max;
  return schema;
}

Json stroke_or_flood() {
  const Json stroke = {{"required", {"stroke"}}, {"properties", {{"flood", {{"const", false}}}}}};
  const Json flood = {{"required", {"flood"}}, {"properties", {{"flood", {{"const", true}}}, {"stroke", false}}}};
  return {stroke, flood};
}

Json text_schema(std::size_t min, std::size_t max) {
  Json schema = {{"type", "string"}};
  if (min > 0) schema["minLength"] = min;
  if (max != any_length) schema["maxLength"] = max;
  return schema;
}

Json described(Json schema, const char* words) {
  if (*words) schema["description"] = words;
  return schema;
}

Json shapes() {
  const Json digits = {{"type", "string"}, {"pattern", "^[0-9a-f]{32}$"}};
  const Json hex = {{"type", "string"}, {"pattern", "^#[0-9a-fA-F]{6}$"}};
  const auto triple = [](Range range) { return list_schema(number_schema("number", range), {3, 3}); };
  const Json component =
      described(number_schema("number", coordinate), "A coordinate; within 1000000 sizes of the model's centre.");
  return {
      {"Position",
       described(list_schema(component, {3, 3}), "A point in the model's own coordinates, right-handed with Y up.")},
      {"Direction",
       described(triple(direction_part), "A vector of any length in [1e-6, 1e6]; only where it points counts.")},
      {"Barycentric", described(triple(share), "Weights of the triangle's corners; their sum is within 0.001 of 1.")},
      {"Colour",
       described({{"oneOf", {hex, triple(share)}}}, "A colour: sRGB as `#rrggbb`, or linear red, green and blue.")},
      {"PictureName", described(digits, "The name that the upload of a picture was answered with.")},
      {"FieldsHash", described(digits, "Hash of all fields: the same fur has the same hash.")}};
}

}  // namespace pelage::json_parts
