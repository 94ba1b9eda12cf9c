// An end to stopping.
#pragma once

#include <chrono>
#include <thread>

namespace pelage {

/// Ends the program with code 0 when some time has gone by since begin(), unless it is destroyed before: the first that
/// is made, so that all that has to be waited for is destroyed before it. What was answered is on disk by then, and
/// what has not ended by itself is for nobody.
class StopDeadline {
 public:
  /// 1 s after the transport cuts off those who still wait, which ends what they wait for.
  static constexpr std::chrono::seconds time{9};

  void begin();

 private:
  std::jthread thread_;
};

}  // namespace pelage
