// Threads that answer requests.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace pelage {

/// Threads that run tasks in the order that they came, urgent ones first. One more thread is reserved for urgent tasks,
/// so that these run while all others are busy. The thread that became idle last gets the next task: the allocator
/// caches freed memory for each thread, so as few threads as possible should work. Thread-safe.
class Workers {
 public:
  using Task = std::function<void()>;  // must not throw

  /// Starts `threads` threads and the reserved one; fewer if the system has no more. Throws std::system_error unless at
  /// least one starts besides the reserved one. Up to `max_waiting` urgent and `max_waiting` other tasks wait.
  Workers(int threads, std::size_t max_waiting);
  /// Runs the waiting tasks, and ends the threads.
  ~Workers();

  /// Adds a task to the queue. Returns false if `max_waiting` tasks of its kind wait already.
  [[nodiscard]] bool enqueue(Task task, bool urgent);

 private:
  /// An idle thread.
  struct Idle {
    std::condition_variable woken;
    bool is_woken = false;
  };

  void work(bool reserved);
  /// Returns whether a thread has a task or should end. `reserved` is true for the reserved thread.
  bool has_work(bool reserved) const { return ending_ || !urgent_.empty() || (!reserved && !common_.empty()); }
  /// Wakes the thread that became idle last. The caller holds the lock.
  static void wake_last(std::vector<Idle*>& idle);
  /// Waits for the next task and returns it; an empty one at the end.
  Task next(bool reserved);
  void end();

  const std::size_t max_waiting_;
  std::mutex mutex_;
  std::vector<Idle*> idle_, reserved_idle_;  // common threads, and the reserved one
  std::deque<Task> urgent_, common_;
  bool ending_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace pelage
