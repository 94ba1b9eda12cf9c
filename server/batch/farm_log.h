// What a farm reads of a process: lines on its output, by the words of Open Job Description and of Flamenco.
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
  /// While a frame is drawn, a heartbeat says so every `interval`: some farms end tasks that stay silent.
  explicit FarmLog(std::chrono::milliseconds interval = std::chrono::seconds(10));
  ~FarmLog();
  FarmLog(const FarmLog&) = delete;
  FarmLog& operator=(const FarmLog&) = delete;

  /// A frame begins, after `done` of `all`.
  void begin(int frame, std::size_t done, std::size_t all);
  void saved(const std::string& file);
  void skipped(const std::string& file);
  void done(std::size_t drawn, std::size_t skipped, double seconds);
  /// Also on the error output, with field, limit and next step.
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
