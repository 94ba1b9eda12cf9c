// A way out of an evaluation whose answer nobody waits for.
#pragma once

#include <functional>
#include <utility>

namespace pelage {

/// Thrown out of an evaluation that nobody waits for any more; nothing has changed then.
struct Cancelled {};

/// Whether somebody still waits. Asked on the evaluation's own thread, between pieces of work of a few microseconds up
/// to a tenth of a second.
class Cancel {
 public:
  Cancel() = default;  // somebody always waits
  explicit Cancel(std::function<bool()> nobody_waits) : nobody_waits_(std::move(nobody_waits)) {}

  /// Throws Cancelled once nobody waits.
  void check() const {
    if (nobody_waits_ && nobody_waits_()) throw Cancelled{};
  }

 private:
  std::function<bool()> nobody_waits_;
};

}  // namespace pelage
