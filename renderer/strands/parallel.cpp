#include "renderer/strands/parallel.h"

#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace pelage {

namespace {

/// A thread that cannot be lowered goes on as it is: then it shares.
void run_only_when_idle() {
  const sched_param none{};
  pthread_setschedparam(pthread_self(), SCHED_IDLE, &none);
}

}  // namespace

bool for_each_piece(const Workers& workers, std::size_t count, const std::function<bool(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> whole{true};
  const auto run = [&] {
    for (std::size_t i = next++; i < count && whole; i = next++) {
      if (!work(i)) whole = false;
    }
  };
  const std::size_t threads = std::min<std::size_t>(static_cast<std::size_t>(std::max(1, workers.threads)), count);
  if (threads <= 1 && !workers.yielding) {
    run();
    return whole;
  }
  std::vector<std::thread> team;
  for (std::size_t i = 0; i < threads; ++i) {
    team.emplace_back([&] {
      if (workers.yielding) run_only_when_idle();
      run();
    });
  }
  for (std::thread& member : team) member.join();
  return whole;
}

}  // namespace pelage
