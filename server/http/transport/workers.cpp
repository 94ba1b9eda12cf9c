#include "server/http/transport/workers.h"

#include <system_error>

namespace pelage {

Workers::Workers(int threads, std::size_t max_waiting) : max_waiting_(max_waiting) {
  threads_.reserve(static_cast<std::size_t>(threads) + 1);
  try {
    for (int k = 0; k <= threads; ++k) threads_.emplace_back([this, reserved = k == 0] { work(reserved); });
  } catch (const std::system_error&) {
    if (threads_.size() >= 2) return;
    end();
    throw;
  }
}

Workers::~Workers() { end(); }

bool Workers::enqueue(Task task, bool urgent) {
  const std::lock_guard lock(mutex_);
  std::deque<Task>& queue = urgent ? urgent_ : common_;
  if (queue.size() >= max_waiting_) return false;
  queue.push_back(std::move(task));
  wake_last(idle_);
  if (urgent) wake_last(reserved_idle_);
  return true;
}

void Workers::wake_last(std::vector<Idle*>& idle) {
  if (idle.empty()) return;
  idle.back()->is_woken = true;
  idle.back()->woken.notify_one();  // under the lock: `Idle` is destroyed when its thread wakes
  idle.pop_back();
}

void Workers::work(bool reserved) {
  while (const Task task = next(reserved)) task();
}

Workers::Task Workers::next(bool reserved) {
  std::unique_lock lock(mutex_);
  while (!has_work(reserved)) {
    Idle own;
    (reserved ? reserved_idle_ : idle_).push_back(&own);
    own.woken.wait(lock, [&] { return own.is_woken; });
  }
  std::deque<Task>& queue = urgent_.empty() && !reserved ? common_ : urgent_;
  if (queue.empty()) return {};
  Task task = std::move(queue.front());
  queue.pop_front();
  return task;
}

void Workers::end() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    while (!idle_.empty()) wake_last(idle_);
    while (!reserved_idle_.empty()) wake_last(reserved_idle_);
  }
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
}

}  // namespace pelage
