// A stopwatch for elapsed time, in seconds or milliseconds.
#pragma once

#include <chrono>

namespace pelage {

/// Measures the time since its construction.
class Stopwatch {
 public:
  using Clock = std::chrono::steady_clock;

  double milliseconds() const { return std::chrono::duration<double, std::milli>(Clock::now() - start_).count(); }
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  Clock::time_point start_ = Clock::now();
};

}  // namespace pelage
