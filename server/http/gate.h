// A bound on how many requests do one costly thing at a time.
#pragma once

#include <atomic>
#include <utility>

namespace pelage {

class Gate {
 public:
  explicit Gate(int places) : places_(places) {}

  /// Holds a place until it is destroyed; false when there was none left.
  class Pass {
   public:
    explicit Pass(Gate* gate) : gate_(gate) {}
    Pass(Pass&& other) noexcept : gate_(std::exchange(other.gate_, nullptr)) {}
    Pass& operator=(Pass&&) = delete;
    ~Pass() {
      if (gate_) ++gate_->places_;
    }
    explicit operator bool() const { return gate_ != nullptr; }

   private:
    Gate* gate_;
  };

  [[nodiscard]] Pass enter() {
    if (--places_ >= 0) return Pass(this);
    ++places_;
    return Pass(nullptr);
  }

 private:
  std::atomic<int> places_;
};

}  // namespace pelage
