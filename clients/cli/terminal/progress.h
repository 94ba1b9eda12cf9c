// Shows the progress of long work on a terminal.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <thread>
#include <utility>

namespace pelage {

struct ProgressState {
  double share = -1;  // fraction that is done, [0, 1]; below 0 if unknown
  std::string words;  // details such as "step 3 of 12"; may be ""
};

/// Returns text such as "running [######..............]  30 %, step 3 of 10, 4 s".
std::string progress_text(const std::string& what, const ProgressState& state, double seconds);

/// Shows a progress line on standard error during its lifetime, after the first second, and erases it at the end. Shows
/// nothing if standard error is not a terminal or with --json.
class ProgressLine {
 public:
  /// Calls `ask` twice a second in a separate thread. Without `ask`, the line shows only the elapsed time.
  explicit ProgressLine(std::string what, std::function<ProgressState()> ask = {});
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

 private:
  void draw() const;

  std::string what_;
  std::function<ProgressState()> ask_;
  std::atomic<bool> done_ = false;
  std::thread thread_;
};

/// Returns the result of `call()`, and shows a line with the elapsed time while it runs.
template <class Call>
auto with_line(std::string what, Call call) {
  const ProgressLine line(std::move(what));
  return call();
}

}  // namespace pelage
