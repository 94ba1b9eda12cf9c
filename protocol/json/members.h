// How a struct is described to the wire, once: `members(visitor, value)` names each member with its range and what it
// means. Decoding, encoding, the JSON Schema, query parameters and the tests' random requests visit the same list.
//
// A visitor has a method for each kind of member (MemberReader in read.cpp is the model), and some that say more:
// type(name, words) names the struct; answer(name, words) one of the server's, whose members are all there unless they
// are sparse; takes(condition) says whether the next members are allowed beside the ones before them; shows(condition)
// whether they mean anything beside the others, and so are written; has(name, condition) whether the object has the
// form with that member; `condition` is the answer for a struct.
#pragma once

#include <type_traits>

#include "base/limits.h"
#include "protocol/json/names.h"
#include "protocol/json/ranges.h"

namespace pelage::json_parts {

/// The struct type that a visitor takes: const for a visitor that reads it, T itself for one that fills it.
template <class Visitor, class T>
using Visited = std::conditional_t<Visitor::reads, const T, T>;

/// Whether a member has to be there, and what it is when it is not.
enum class Presence {
  defaulted,  // the struct's own value
  sparse,     // the struct's own value, which is empty and then not written
  required,
  tag,  // required, and tells one form of the struct from another
  bare  // a rule of the struct says when it has to be there, and no default is named
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

/// Returns whether a member has to be there. In an `answer` every member has to, except sparse and bare ones.
constexpr bool is_required(MemberName name, bool answer) {
  return name.presence == Presence::required || name.presence == Presence::tag ||
         (answer && name.presence == Presence::defaulted);
}

}  // namespace pelage::json_parts
