// A gate at which background work yields to work that a client waits for.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>

namespace pelage {

/// Thread-safe. Holders of a Priority never wait.
class YieldGate {
 public:
  /// Makes yielding threads wait, as long as it lives.
  class Priority {
   public:
    explicit Priority(YieldGate& gate);
    ~Priority();
    Priority(const Priority&) = delete;
    Priority& operator=(const Priority&) = delete;

   private:
    YieldGate& gate_;
  };

  [[nodiscard]] Priority take_priority() { return Priority(*this); }

  /// Waits while any Priority lives and `wanted` returns true, and returns the final result of `wanted`. Whoever makes
  /// it false must call wake(). `wanted` must not use the gate.
  bool pass(const std::function<bool()>& wanted);
  void wake();

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int priorities_ = 0;
};

}  // namespace pelage
