// Error codes and results, inside the program and on the wire. Bad input is a Status; a programming error is an assert.
#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace pelage {

/// Kinds of failure; server/http maps each to one HTTP status.
enum class Code {
  ok,
  malformed,     // 400: not JSON, not HTTP, duplicate keys, nested too deeply, numbers beyond a double
  not_found,     // 404
  conflict,      // 409: model was replaced, no room for a scene, idempotency clash, superseded frame
  precondition,  // 412: If-Match names another revision
  too_large,     // 413
  unsupported,   // 415
  invalid,       // 422: breaks the contract; pointer and limit say where and how
  busy,          // 429
  internal,      // 500
  unavailable,   // 503
};

/// The outcome of a call that can be refused. `pointer` is a JSON pointer to the bad field ("" for the whole body),
/// `limit` describes the violated limit ("[0, 1]"), and `nearest` is the known name nearest to an unknown one. `next`
/// tells the user of a program what to do if the code alone does not say it; it is not sent over the wire.
struct Status {
  Code code = Code::ok;
  std::string message;
  std::string pointer;
  std::string limit;
  std::string nearest;
  std::string next = {};

  bool ok() const { return code == Code::ok; }
};

inline Status failure(Code code, std::string message, std::string pointer = {}, std::string limit = {},
                      std::string nearest = {}) {
  return {code, std::move(message), std::move(pointer), std::move(limit), std::move(nearest)};
}

inline Status with_next(Status status, std::string next) {
  status.next = std::move(next);
  return status;
}

/// A value, or the reason why there is none.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}                                        // NOLINT: implicit on purpose
  Result(Status status) : state_(std::move(status)) { assert(!this->status().ok()); }  // NOLINT

  bool ok() const { return std::holds_alternative<T>(state_); }
  explicit operator bool() const { return ok(); }
  const Status& status() const { return std::get<Status>(state_); }
  T& value() & { return std::get<T>(state_); }
  const T& value() const& { return std::get<T>(state_); }
  T&& value() && { return std::get<T>(std::move(state_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

 private:
  std::variant<Status, T> state_;
};

}  // namespace pelage
