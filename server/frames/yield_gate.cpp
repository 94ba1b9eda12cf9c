#include "server/frames/yield_gate.h"

namespace pelage {

YieldGate::Turn::Turn(YieldGate& gate) : gate_(gate) {
  const std::lock_guard lock(gate_.mutex_);
  ++gate_.first_;
}

YieldGate::Turn::~Turn() {
  const std::lock_guard lock(gate_.mutex_);
  if (--gate_.first_ == 0) gate_.changed_.notify_all();
}

bool YieldGate::pass(const std::function<bool()>& wanted) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return first_ == 0 || !wanted(); });
  lock.unlock();
  return wanted();
}

void YieldGate::wake() {
  const std::lock_guard lock(mutex_);
  changed_.notify_all();
}

}  // namespace pelage
