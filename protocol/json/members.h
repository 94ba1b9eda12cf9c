// How a struct is described to the wire, once: `members(visitor, value)` names each member with its range and what it
// means. Decoding, encoding, the JSON Schema, query parameters and the tests' random requests visit the same list.
//
// A visitor has a method for each kind of member (MemberReader in read.cpp is the model), and three that say more:
// type(name, words) names the struct; takes(condition) whether members are known at all beside the ones before them;
// shows(condition) whether they say anything beside the others, and so are written.
#pragma once

#include <type_traits>

#include "protocol/base/limits.h"
#include "protocol/json/names.h"
#include "protocol/json/ranges.h"

namespace pelage::json_parts {

/// A struct that a visitor fills, or reads.
template <class Visitor, class T>
using Visited = std::conditional_t<Visitor::reads, const T, T>;

/// Whether a member has to be there, and what it is when it is not.
enum class Presence {
  defaulted,  // the struct's own value
  sparse,     // the same, which is empty and not written
  required,
  bare  // a rule of the struct says when it has to be there, and no default is named
};

struct MemberName {
  const char* text;
  Presence presence = Presence::defaulted;
  constexpr MemberName(const char* name, Presence how = Presence::defaulted) : text(name), presence(how) {}  // NOLINT
};

constexpr MemberName required(const char* name) { return {name, Presence::required}; }
constexpr MemberName sparse(const char* name) { return {name, Presence::sparse}; }
constexpr MemberName bare(const char* name) { return {name, Presence::bare}; }

}  // namespace pelage::json_parts
