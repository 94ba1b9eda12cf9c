#include "server/process/signals.h"

#include <initializer_list>

namespace pelage {

StopSignals::StopSignals() {
  sigemptyset(&signals_);
  sigaddset(&signals_, SIGTERM);
  sigaddset(&signals_, SIGINT);
  pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
  for (const int number : {SIGHUP, SIGPIPE, SIGXFSZ}) ::signal(number, SIG_IGN);
}

StopSignals::Stop StopSignals::wait() const {
  siginfo_t info{};
  while (sigwaitinfo(&signals_, &info) < 0) {  // EINTR if the process was stopped and continued
  }
  return {info.si_signo, info.si_code == SI_KERNEL ? 0 : info.si_pid};
}

}  // namespace pelage
