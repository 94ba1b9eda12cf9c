// A gate at which background work yields to work that a client waits for.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>

namespace pelage {

/// Thread-safe. Holders of a Turn never wait.
class YieldGate {
 public:
  /// Makes yielding threads wait, as long as it lives.
  class Turn {
   public:
    explicit Turn(YieldGate& gate);
    ~Turn();
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

   private:
    YieldGate& gate_;
  };

  [[nodiscard]] Turn go_first() { return Turn(*this); }

  /// Waits while any Turn lives and `wanted` returns true, and returns the final result of `wanted`. Whoever makes it
  /// false must call wake(). `wanted` must not use the gate.
  bool pass(const std::function<bool()>& wanted);
  void wake();

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int first_ = 0;
};

}  // namespace pelage
