#include "server/process/stop_deadline.h"

#include <unistd.h>

#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <stop_token>

namespace pelage {

void StopDeadline::begin() {
  thread_ = std::jthread([](const std::stop_token& ended) {
    std::mutex mutex;
    std::condition_variable_any passed;
    std::unique_lock lock(mutex);
    passed.wait_for(lock, ended, time, [] { return false; });
    if (ended.stop_requested()) return;
    std::fputs("pelaged: stopped, and cut off what had not ended\n", stdout);
    std::fflush(stdout);
    _exit(0);
  });
}

}  // namespace pelage
