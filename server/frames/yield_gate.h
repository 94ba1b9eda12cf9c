// Lets work that somebody waits for go before work that nobody does.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>

namespace pelage {

/// Thread-safe. Those who go first never wait.
class YieldGate {
 public:
  /// Holds back threads that yield until it is destroyed.
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

  /// Waits while anyone goes first and `wanted` holds; what `wanted` says at the end. Whoever makes it false calls
  /// wake(). `wanted` may not use the gate.
  bool pass(const std::function<bool()>& wanted);
  void wake();

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int first_ = 0;
};

}  // namespace pelage
