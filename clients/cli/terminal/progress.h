// Shows the progress of long work on a terminal.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <thread>
#include <utility>

namespace pelage {

struct ProgressState {
  double share = -1;    // fraction that is done, [0, 1]; below 0 if unknown
  std::string details;  // details such as "step 3 of 12"; may be ""
};

/// Returns text such as "running [######..............]  30 %, step 3 of 10, 4 s".
std::string progress_text(const std::string& label, const ProgressState& state, double seconds);

/// Shows a progress line on standard error during its lifetime, after the first second, and erases it at the end. Shows
/// nothing if standard error is not a terminal or with --json.
class ProgressLine {
 public:
  /// Calls `get_state` twice a second in a separate thread. Without it, the line shows only the elapsed time.
  explicit ProgressLine(std::string label, std::function<ProgressState()> get_state = {});
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

 private:
  void draw() const;

  std::string label_;
  std::function<ProgressState()> get_state_;
  std::atomic<bool> done_ = false;
  std::thread thread_;
};

/// Returns the result of `call()`, and shows a line with the elapsed time while it runs.
template <class Call>
auto with_progress_line(std::string label, Call call) {
  const ProgressLine line(std::move(label));
  return call();
}

}  // namespace pelage
