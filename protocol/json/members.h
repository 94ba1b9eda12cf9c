// Describes the JSON form of each struct, in one place: `members(visitor, value)` names each member with its range and
// meaning. Decoding, encoding, the JSON Schema, query parameters and the tests' random requests visit the same list.
//
// A visitor has a method for each kind of member (MemberReader in read.cpp is the model), and these:
// - type(name, words) names the struct.
// - answer(name, words) names one of the server's answers, whose members are all present unless they are sparse.
// - takes(condition) returns whether the members that follow are allowed, given the ones before them.
// - shows(condition) returns whether the members that follow matter, given the others, and so are written.
// - has(name, condition) returns whether the object has the form with the member `name`.
// `condition` is what the values of the visited struct say; a visitor may have other information.
#pragma once

#include <type_traits>

#include "base/limits.h"
#include "protocol/json/names.h"
#include "protocol/json/ranges.h"

namespace pelage::json_parts {

/// The struct type that a visitor takes: const for a visitor that reads it, T itself for one that fills it.
template <class Visitor, class T>
using Visited = std::conditional_t<Visitor::reads, const T, T>;

/// Whether a member is required, and its value if it is absent.
enum class Presence {
  defaulted,  // optional; the struct's default value
  sparse,     // optional; the default value is empty, and empty values are not written
  required,
  tag,  // required; its value distinguishes the forms of the struct
  bare  // a rule of the struct says when it is required; the schema states no default
};

struct MemberName {
  const char* text;
  Presence presence = Presence::defaulted;
  constexpr MemberName(const char* name, Presence how = Presence::defaulted) : text(name), presence(how) {}  // NOLINT
};

constexpr MemberName required(const char* name) { return {name, Presence::required}; }
constexpr MemberName sparse(const char* name) { return {name, Presence::sparse}; }
constexpr MemberName tag(const char* name) { return {name, Presence::tag}; }
constexpr MemberName bare(const char* name) { return {name, Presence::bare}; }

/// Returns whether a member is required. In an `answer` every member is, except sparse and bare ones.
constexpr bool is_required(MemberName name, bool answer) {
  return name.presence == Presence::required || name.presence == Presence::tag ||
         (answer && name.presence == Presence::defaulted);
}

}  // namespace pelage::json_parts
