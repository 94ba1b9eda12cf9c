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
/// so that these run while all others are busy. Of the waiting threads the one that worked last works next: each thread
/// keeps some freed memory for itself, so that as few threads as possible should work. Thread-safe.
class Workers {
 public:
  using Task = std::function<void()>;  // throws nothing

  /// Starts `threads` threads and the reserved one; fewer where the machine has no more (one at least, or
  /// std::system_error). Up to `max_waiting` tasks of each kind wait.
  Workers(int threads, std::size_t max_waiting);
  /// Runs what waits, and ends the threads.
  ~Workers();

  /// False when as many tasks wait already as may.
  [[nodiscard]] bool give(Task task, bool urgent);

 private:
  /// A thread that waits.
  struct Idle {
    std::condition_variable called;
    bool is_called = false;
  };

  void work(bool kept);
  /// Returns whether a thread has something to do, or to end.
  bool has_work(bool kept) const { return ending_ || !urgent_.empty() || (!kept && !common_.empty()); }
  /// Wakes the last of the waiting threads. The lock is held.
  static void call_last(std::vector<Idle*>& idle);
  /// The next task; an empty one at the end.
  Task next(bool kept);
  void end();

  const std::size_t max_waiting_;
  std::mutex mutex_;
  std::vector<Idle*> idle_, kept_idle_;  // common threads, and the reserved one
  std::deque<Task> urgent_, common_;
  bool ending_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace pelage
