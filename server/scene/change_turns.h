// Serializes the changes of one scene.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <utility>

#include "base/status.h"
#include "server/groom/cancel.h"

namespace pelage {

/// A fair lock: changes run one at a time, in the order in which they arrive. Thread-safe.
class ChangeTurns {
 public:
  /// Maximum number of waiting changes. Each of them blocks a server thread, and other clients need threads too.
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

  /// Waits until all earlier changes have ended. Refuses with `busy` if too many changes wait already, with
  /// `unavailable` if cancelled meanwhile; `cancel` is polled ten times a second.
  Result<Turn> take(const Cancel& cancel = {});

 private:
  void end();

  std::mutex mutex_;
  std::condition_variable ended_;
  std::deque<std::uint64_t> waiting_;  // tickets in order of arrival
  std::uint64_t next_ticket_ = 0;
  bool taken_ = false;
};

}  // namespace pelage
