// Runs another program with an input and reads its output, until a deadline.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"

namespace pelage {

struct ChildLimits {
  double seconds;                        // wall time, after which the child is killed
  std::size_t answer_bytes;              // maximum on its standard output; above it the child is killed
  std::function<bool()> cancelled = {};  // called four times a second; the child is killed if it returns true
};

/// The end of a child, and its error output.
struct ChildResult {
  std::string complaint;   // the first 4 KiB of its standard error
  bool timed_out = false;  // killed at the deadline
  bool too_long = false;   // killed because its answer grew over the limit
  bool cancelled = false;  // killed because limits.cancelled returned true
  int exit_code = -1;      // -1 if a signal ended it
  int signal = 0;          // 0 if it exited
};

/// Takes the next bytes of a child's standard output. Returns false to end the child.
using TakeAnswer = std::function<bool(std::string_view)>;

/// Runs arguments[0] with three standard streams and nothing else of this process: no other descriptor, an empty
/// environment, default signals. Fails: internal if it cannot be started, unavailable if there are no sockets for it.
Result<ChildResult> run_child(const std::vector<std::string>& arguments, std::span<const std::byte> input,
                              const ChildLimits& limits, const TakeAnswer& take);

}  // namespace pelage
