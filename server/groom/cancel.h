// Cancellation of evaluations whose client is gone.
#pragma once

#include <functional>
#include <utility>

#include "base/status.h"

namespace pelage {

/// Thrown out of a cancelled evaluation; nothing has changed then.
struct Cancelled {};

/// The status that the caller of a cancelled evaluation gets, in case the caller still listens.
inline Status nobody_waits() {
  return failure(Code::unavailable, "nobody waits for the answer any more, so nothing was changed");
}

/// Tells whether the evaluation is cancelled, because no client waits for its answer. It is polled on the evaluation's
/// own thread, every few microseconds to a tenth of a second.
class Cancel {
 public:
  Cancel() = default;  // never cancelled
  explicit Cancel(std::function<bool()> nobody_waits) : nobody_waits_(std::move(nobody_waits)) {}

  bool asked() const { return nobody_waits_ && nobody_waits_(); }
  /// Throws Cancelled if the evaluation is cancelled.
  void check() const {
    if (asked()) throw Cancelled{};
  }

 private:
  std::function<bool()> nobody_waits_;
};

}  // namespace pelage
