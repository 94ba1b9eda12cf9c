// Readers of the values of a JSON tree. A refusal has the JSON pointer and, for a misspelled name, the nearest known
// one.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"
#include "protocol/json/names.h"
#include "protocol/json/ranges.h"

namespace pelage {

/// Returns the word of `known` with the smallest edit distance to `word` (its first 80 bytes), the first of several.
std::string nearest_name(std::string_view word, const std::vector<std::string_view>& known);
bool has_control_character(std::string_view text);
bool is_utf8(std::string_view text);

/// How strictly a document is read. strict: it has to follow the contract exactly. tolerant: it comes from a server
/// that may be newer, so unknown members and words are ignored, and limits may have grown.
enum class Reading { strict, tolerant };

/// A value of the tree, and its JSON pointer. All values of a document share a status, which keeps the first refusal;
/// after it readers return defaults, and the caller checks the status once, at the end.
class Value {
 public:
  Value(const nlohmann::json& value, std::string pointer, Status& first_failure, Reading reading = Reading::strict)
      : json_(&value),
        pointer_(std::move(pointer)),
        failure_(&first_failure),
        tolerant_(reading == Reading::tolerant) {}

  void refuse(std::string message, std::string limit = {}, std::string nearest = {}) const;
  /// Refuses a value below this one; `path` is a JSON pointer without its first slash.
  void refuse_below(const std::string& path, std::string message, std::string limit = {}) const;

  /// Returns whether nothing in the document has been refused so far.
  bool ok() const { return failure_->ok(); }
  const nlohmann::json& tree() const { return *json_; }
  bool tolerant() const { return tolerant_; }
  /// Returns a member that exists.
  Value member(std::string_view name) const;

  double number(Range range) const;
  std::int64_t integer(Range range) const;
  std::uint64_t counter() const;  // an integer of 64 bits, 0 or more
  bool boolean() const;
  std::string text(std::size_t min_bytes, std::size_t max_bytes) const;  // no control characters
  glm::dvec2 pair(Range range) const;
  glm::dvec3 triple(Range range) const;
  glm::dvec3 direction() const;  // length in [1e-6, 1e6]
  glm::vec3 colour() const;      // "#rrggbb" (sRGB) or [r, g, b] (linear, each in [0, 1]) to linear
  std::vector<Value> list(std::size_t min, std::size_t max) const;

  /// Returns a text that is one of `known`; if tolerant, any text.
  std::string word_of(const std::vector<std::string_view>& known) const;
  template <class E, std::size_t N>
  E name_of(const std::array<json_names::Name<E>, N>& names) const;  // the first if it is none of them

 private:
  const nlohmann::json* json_;
  std::string pointer_;
  Status* failure_;
  bool tolerant_;
};

/// A JSON object. Names that were asked for are known; finish() refuses all others.
class Object {
 public:
  explicit Object(const Value& value);

  bool has(std::string_view name);
  /// Calls `read(Value)` if the member exists.
  template <class Read>
  void optional(std::string_view name, Read read) {
    if (has(name)) read(value_.member(name));
  }
  /// As optional, but refuses a missing member.
  template <class Read>
  void required(std::string_view name, Read read) {
    if (has(name))
      read(value_.member(name));
    else
      value_.refuse_below(std::string(name), "The member \"" + std::string(name) + "\" is missing.", "required");
  }

  void number(std::string_view name, double& out, Range range);
  void integer(std::string_view name, int& out, Range range);
  void integer(std::string_view name, std::uint32_t& out);
  void boolean(std::string_view name, bool& out);
  void triple(std::string_view name, glm::dvec3& out, Range range);
  void colour(std::string_view name, glm::vec3& out);
  template <class E, std::size_t N>
  void name(std::string_view name, E& out, const std::array<json_names::Name<E>, N>& names) {
    optional(name, [&](const Value& value) { out = value.name_of(names); });
  }

  const Value& value() const { return value_; }
  /// Refuses members that were not asked for. Call it last.
  void finish() const;

 private:
  Value value_;
  std::vector<std::string_view> known_;
};

template <class E, std::size_t N>
E Value::name_of(const std::array<json_names::Name<E>, N>& names) const {
  const std::string word = word_of(texts_of(names));
  for (const auto& name : names) {
    if (name.text == word) return name.value;
  }
  return names.front().value;
}

}  // namespace pelage
