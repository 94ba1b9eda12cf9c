#include "server/frames/yield_gate.h"

namespace pelage {

YieldGate::Priority::Priority(YieldGate& gate) : gate_(gate) {
  const std::lock_guard lock(gate_.mutex_);
  ++gate_.priorities_;
}

YieldGate::Priority::~Priority() {
  const std::lock_guard lock(gate_.mutex_);
  if (--gate_.priorities_ == 0) gate_.changed_.notify_all();
}

bool YieldGate::pass(const std::function<bool()>& wanted) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return priorities_ == 0 || !wanted(); });
  lock.unlock();
  return wanted();
}

void YieldGate::wake() {
  const std::lock_guard lock(mutex_);
  changed_.notify_all();
}

}  // namespace pelage
