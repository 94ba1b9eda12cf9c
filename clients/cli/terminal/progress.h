// The progress of long work, shown to a user at a terminal.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <thread>
#include <utility>

namespace pelage {

struct ProgressState {
  double share = -1;  // done, [0, 1]; below 0 where nobody knows
  std::string words;  // such as "step 3 of 12"
};

/// "running [######..............]  30 %, step 3 of 10, 4 s".
std::string progress_text(const std::string& what, const ProgressState& state, double seconds);

/// Shows progress from its construction to its destruction: one line on standard error, from the first second on, which
/// is erased in the end. Shows nothing where that is no terminal or JSON is wanted.
class ProgressLine {
 public:
  /// `ask` is called twice a second in a thread of its own; without it the line says how long it took so far.
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

/// Returns what `call` returns, and shows meanwhile how long it takes.
template <class Call>
auto with_line(std::string what, Call call) {
  const ProgressLine line(std::move(what));
  return call();
}

}  // namespace pelage
