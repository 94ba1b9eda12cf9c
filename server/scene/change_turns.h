// The order of a scene's changes.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <utility>

#include "base/status.h"
#include "server/groom/cancel.h"

namespace pelage {

/// Changes take turns, one at a time, in the order that they came in. Thread-safe.
class ChangeTurns {
 public:
  /// Most changes that wait. Each holds a thread of whoever serves its client, and other clients need threads too.
  static constexpr std::size_t max_waiting = 32;

  class Turn {
   public:
    explicit Turn(ChangeTurns& turns) : turns_(&turns) {}
    Turn(Turn&& other) noexcept : turns_(std::exchange(other.turns_, nullptr)) {}
    Turn& operator=(Turn&&) = delete;
    ~Turn() {
      if (turns_ != nullptr) turns_->end();
    }

   private:
    ChangeTurns* turns_;
  };

  /// Waits until the changes before have ended. Refused: busy while too many wait, unavailable once nobody waits for
  /// the answer (asked ten times a second).
  Result<Turn> take(const Cancel& cancel = {});

 private:
  void end();

  std::mutex mutex_;
  std::condition_variable ended_;
  std::deque<std::uint64_t> waiting_;  // in order
  std::uint64_t came_ = 0;
  bool taken_ = false;
};

}  // namespace pelage
