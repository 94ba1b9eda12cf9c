#include "protocol/json/reader.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "protocol/json/colour.h"
#include "protocol/json/parse.h"

namespace pelage {

namespace {

constexpr std::size_t compared_bytes = 80;

/// Levenshtein distance, one row at a time.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t k = 1; k <= b.size(); ++k) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[k - 1] ? 0 : 1);
      diagonal = row[k];
      row[k] = std::min({row[k] + 1, row[k - 1] + 1, substituted});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_name(std::string_view word, const std::vector<std::string_view>& known) {
  const std::string_view compared = word.substr(0, compared_bytes);
  std::string_view best;
  std::size_t min = std::string_view::npos;
  for (const std::string_view name : known) {
    const std::size_t distance = edit_distance(compared, name);
    if (distance < min) {
      min = distance;
      best = name;
    }
  }
  return std::string(best);
}

namespace {

using nlohmann::json;

constexpr std::size_t max_quoted_bytes = 80;  // largest part of a user's word that a message quotes

/// Formats a number; a whole one as "9000", not "9000.0".
std::string short_number(double value) {
  const bool is_integer = value == std::floor(value) && std::abs(value) < 1e15;
  return is_integer ? std::to_string(static_cast<long long>(value)) : json(value).dump();
}

std::string in_quotes(std::string_view word) {
  return "\"" + std::string(word.substr(0, max_quoted_bytes)) + (word.size() > max_quoted_bytes ? "...\"" : "\"");
}

}  // namespace

bool has_control_character(std::string_view text) {
  return std::any_of(text.begin(), text.end(),
                     [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
}

bool is_utf8(std::string_view text) {
  return json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace)) == text;
}

std::string Range::text() const { return "[" + short_number(low) + ", " + short_number(high) + "]"; }

void Value::refuse(std::string message, std::string limit, std::string nearest) const {
  if (!failure_->ok()) return;
  *failure_ = failure(Code::invalid, std::move(message), pointer_, std::move(limit), std::move(nearest));
}

void Value::refuse_below(const std::string& path, std::string message, std::string limit) const {
  Value(*json_, pointer_ + "/" + path, *failure_).refuse(std::move(message), std::move(limit));
}

Value Value::member(std::string_view name) const {
  Value value = *this;
  value.json_ = &json_->at(name), value.pointer_ += pointer_step(name);
  return value;
}

double Value::number(Range range) const {
  if (!json_->is_number()) {
    refuse("A number is expected.", range.text());
    return range.low;
  }
  const double value = json_->get<double>();
  if (tolerant_ || (value >= range.low && value <= range.high)) return value;
  refuse(short_number(value) + " is out of range.", range.text());
  return range.low;
}

std::int64_t Value::integer(Range range) const {
  const double value = number(range);
  if (value != std::floor(value)) refuse("A whole number is expected.", range.text());
  return static_cast<std::int64_t>(std::clamp(value, -9e18, 9e18));
}

std::uint64_t Value::counter() const {
  if (json_->is_number_unsigned()) return json_->get<std::uint64_t>();
  refuse("A whole number is expected.", "[0, 18446744073709551615]");
  return 0;
}

bool Value::boolean() const {
  if (json_->is_boolean()) return json_->get<bool>();
  refuse("true or false is expected.", "true | false");
  return false;
}

std::string Value::text(std::size_t min_bytes, std::size_t max_bytes) const {
  const std::string limit =
      std::to_string(min_bytes) + " to " + std::to_string(max_bytes) + " bytes of UTF-8 without control characters";
  if (!json_->is_string()) {
    refuse("A text is expected.", limit);
    return {};
  }
  const std::string& text = json_->get_ref<const std::string&>();
  if (tolerant_) return text;
  if (text.size() < min_bytes || text.size() > max_bytes) {
    refuse("The text has " + std::to_string(text.size()) + " bytes.", limit);
    return {};
  }
  if (has_control_character(text)) refuse("The text has control characters.", limit);
  return text;
}

glm::dvec2 Value::pair(Range range) const {
  const std::vector<Value> parts = list(2, 2);
  return parts.empty() ? glm::dvec2(0) : glm::dvec2(parts[0].number(range), parts[1].number(range));
}

glm::dvec3 Value::triple(Range range) const {
  const std::vector<Value> parts = list(3, 3);
  if (parts.empty()) return glm::dvec3(0);
  return {parts[0].number(range), parts[1].number(range), parts[2].number(range)};
}

glm::dvec3 Value::direction() const {
  const glm::dvec3 vector = triple(json_parts::direction_part);
  if (const double length = glm::length(vector); length >= 1e-6 && length <= 1e6) return vector;
  refuse("The direction has no usable length.", "a length in [1e-6, 1e6]");
  return {0, -1, 0};
}

glm::vec3 Value::colour() const {
  if (json_->is_string()) {
    if (const auto colour = colour_of_text(json_->get_ref<const std::string&>())) return *colour;
  } else if (json_->is_array()) {
    return glm::vec3(triple({0, 1}));
  }
  refuse("This is no colour.", "\"#rrggbb\" (sRGB) or [r, g, b] (linear, each in [0, 1])");
  return glm::vec3(0);
}

std::vector<Value> Value::list(std::size_t min, std::size_t max) const {
  const std::string limit = min == max ? "a list of " + std::to_string(min)
                                       : "a list of " + std::to_string(min) + " to " + std::to_string(max);
  if (!json_->is_array()) {
    refuse("A list is expected.", limit);
    return {};
  }
  const bool may_grow = tolerant_ && min < max;
  if (json_->size() < min || (json_->size() > max && !may_grow)) {
    refuse("The list has " + std::to_string(json_->size()) + " members.", limit);
    return {};
  }
  std::vector<Value> values;
  values.reserve(json_->size());
  for (const json& member : *json_) {
    Value& value = values.emplace_back(*this);
    value.json_ = &member, value.pointer_ += "/" + std::to_string(values.size() - 1);
  }
  return values;
}

std::string Value::word_of(const std::vector<std::string_view>& known) const {
  std::string limit;
  for (const std::string_view name : known) limit += (limit.empty() ? "" : " | ") + std::string(name);
  if (!json_->is_string()) {
    refuse("A name is expected.", limit);
    return {};
  }
  std::string word = json_->get<std::string>();
  if (!tolerant_ && std::find(known.begin(), known.end(), word) == known.end()) {
    refuse(in_quotes(word) + " is not known here.", limit, nearest_name(word, known));
  }
  return word;
}

Object::Object(const Value& value) : value_(value) {
  if (!value.tree().is_object()) value.refuse("An object is expected.", "{...}");
}

bool Object::has(std::string_view name) {
  known_.push_back(name);
  return value_.tree().is_object() && value_.tree().contains(name);
}

void Object::number(std::string_view name, double& out, Range range) {
  optional(name, [&](const Value& value) { out = value.number(range); });
}

void Object::integer(std::string_view name, int& out, Range range) {
  optional(name, [&](const Value& value) { out = static_cast<int>(value.integer(range)); });
}

void Object::integer(std::string_view name, std::uint32_t& out) {
  optional(name, [&](const Value& value) { out = static_cast<std::uint32_t>(value.integer({0, 4294967295.0})); });
}

void Object::boolean(std::string_view name, bool& out) {
  optional(name, [&](const Value& value) { out = value.boolean(); });
}

void Object::triple(std::string_view name, glm::dvec3& out, Range range) {
  optional(name, [&](const Value& value) { out = value.triple(range); });
}

void Object::colour(std::string_view name, glm::vec3& out) {
  optional(name, [&](const Value& value) { out = value.colour(); });
}

void Object::finish() const {
  if (!value_.tree().is_object() || value_.tolerant()) return;
  for (const auto& [name, ignored] : value_.tree().items()) {
    if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
    value_.member(name).refuse(in_quotes(name) + " is not known here.", "", nearest_name(name, known_));
  }
}

}  // namespace pelage
