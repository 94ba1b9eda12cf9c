#include "server/scene/change_turns.h"

#include <algorithm>
#include <chrono>
#include <string>

namespace pelage {

Result<ChangeTurns::Turn> ChangeTurns::take(const Cancel& cancel) {
  constexpr std::chrono::milliseconds look_again(100);  // interval at which `cancel` is polled
  std::unique_lock lock(mutex_);
  if (waiting_.size() >= max_waiting) {
    return failure(Code::busy, "too many changes of the scene wait", "",
                   "at most " + std::to_string(max_waiting) + " that wait");
  }
  const std::uint64_t own = next_ticket_++;
  waiting_.push_back(own);
  while (taken_ || waiting_.front() != own) {
    ended_.wait_for(lock, look_again);
    lock.unlock();
    const bool left = cancel.asked();
    lock.lock();
    if (!left) continue;
    waiting_.erase(std::find(waiting_.begin(), waiting_.end(), own));
    ended_.notify_all();  // the next in line may proceed now
    return nobody_waits();
  }
  waiting_.pop_front();
  taken_ = true;
  return Turn(*this);
}

void ChangeTurns::end() {
  const std::lock_guard lock(mutex_);
  taken_ = false;
  ended_.notify_all();
}

}  // namespace pelage
