// Signals that a program is sent: two ask it to stop, and none kills it half-way.
#pragma once

#include <signal.h>

namespace pelage {

/// SIGTERM and SIGINT ask a program to stop. They are blocked in every thread that starts while this lives, and in the
/// one that made it: a thread of the program's own waits for them. Ignored from here on, in the whole process: SIGHUP,
/// as there are no settings to read anew and a terminal that closes is no reason to stop; SIGPIPE and SIGXFSZ, as a
/// write that fails says so.
class StopSignals {
 public:
  StopSignals();

  struct Stop {
    int signal = 0;
    pid_t sender = 0;  // 0 where the kernel sent it, as for a key
  };

  /// Waits for a signal and returns it. Keeps waiting when the process is stopped and continued, or attached to a
  /// debugger.
  Stop wait() const;

 private:
  sigset_t signals_;
};

}  // namespace pelage
