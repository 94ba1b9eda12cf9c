// Cancels an evaluation whose answer nobody waits for.
#pragma once

#include <functional>
#include <utility>

#include "base/status.h"

namespace pelage {

/// Thrown out of an evaluation that nobody waits for any more; nothing has changed then.
struct Cancelled {};

/// The status that the caller of a cancelled evaluation gets, in case the caller still listens.
inline Status nobody_waits() {
  return failure(Code::unavailable, "nobody waits for the answer any more, so nothing was changed");
}

/// Tells whether somebody still waits. It is asked on the evaluation's own thread, every few microseconds to a tenth of
/// a second.
class Cancel {
 public:
  Cancel() = default;  // somebody always waits
  explicit Cancel(std::function<bool()> nobody_waits) : nobody_waits_(std::move(nobody_waits)) {}

  bool asked() const { return nobody_waits_ && nobody_waits_(); }
  /// Throws Cancelled once nobody waits.
  void check() const {
    if (asked()) throw Cancelled{};
  }

 private:
  std::function<bool()> nobody_waits_;
};

}  // namespace pelage
