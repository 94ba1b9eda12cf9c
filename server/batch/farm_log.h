// Writes the lines on standard output that farms parse, with the keywords of Open Job Description and of Flamenco.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "base/status.h"

namespace pelage {

/// Thread-safe. Each line is written whole and at once.
class FarmLog {
 public:
  /// While a frame is drawn, a heartbeat is written every `interval`: some farms end tasks that stay silent.
  explicit FarmLog(std::chrono::milliseconds interval = std::chrono::seconds(10));
  ~FarmLog();
  FarmLog(const FarmLog&) = delete;
  FarmLog& operator=(const FarmLog&) = delete;

  /// Reports that a frame begins, after `done` of `all` files.
  void begin(int frame, std::size_t done, std::size_t all);
  void saved(const std::string& file);
  void skipped(const std::string& file);
  void done(std::size_t drawn, std::size_t skipped, double seconds);
  /// Reports a failure, also on standard error with field, limit and next step.
  void failed(const Status& status);

 private:
  void beat(std::chrono::milliseconds interval);

  std::mutex mutex_;
  std::condition_variable ended_;
  bool ending_ = false, drawing_ = false;
  int frame_ = 0;
  std::chrono::steady_clock::time_point begun_;
  std::thread heart_;
};

}  // namespace pelage
