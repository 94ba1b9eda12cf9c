// Another program, fed and listened to until a deadline.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"

namespace pelage {

struct ChildLimits {
  double seconds;                        // of wall time, then it is killed
  std::size_t answer_bytes;              // on its standard output, then it is killed
  std::function<bool()> cancelled = {};  // asked four times a second; then it is killed
};

/// How a child ended and what it said.
struct ChildResult {
  std::string complaint;   // the first 4 KiB of its standard error
  bool timed_out = false;  // killed at the deadline
  bool too_long = false;   // killed because its answer grew over the limit
  bool cancelled = false;  // killed because nobody waited for it
  int exit_code = -1;      // -1 when a signal ended it
  int signal = 0;          // 0 when it exited
};

/// Takes the next bytes of a child's standard output; false ends it.
using TakeAnswer = std::function<bool(std::string_view)>;

/// Runs arguments[0] with nothing of this process but the three standard streams: no other descriptor, an empty
/// environment, default signals. Refused (internal) when it cannot be started.
Result<ChildResult> run_child(const std::vector<std::string>& arguments, std::span<const std::byte> input,
                              const ChildLimits& limits, const TakeAnswer& take);

}  // namespace pelage
