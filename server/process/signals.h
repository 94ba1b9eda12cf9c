// Handles the signals of a program: two ask it to stop, and some that would kill it are ignored.
#pragma once

#include <signal.h>

namespace pelage {

/// SIGTERM and SIGINT ask a program to stop. The constructor blocks them in its thread and in threads that this starts
/// later, so that one thread can wait for them. It also ignores, in the whole process, SIGHUP, since there are no
/// settings to reload and a terminal that closes is no reason to stop, and SIGPIPE and SIGXFSZ, since the failing write
/// returns an error.
class StopSignals {
 public:
  StopSignals();

  struct Stop {
    int signal = 0;
    pid_t sender = 0;  // 0 if the kernel sent it, for example for Ctrl+C
  };

  /// Waits for a stop signal and returns it. Keeps waiting if the process is stopped and continued, or attached to a
  /// debugger.
  Stop wait() const;

 private:
  sigset_t signals_;
};

}  // namespace pelage
