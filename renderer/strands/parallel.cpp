#include "renderer/strands/parallel.h"

#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "protocol/base/parallel.h"

namespace pelage {

namespace {

/// A thread that cannot be lowered goes on as it is: then it shares.
void run_only_when_idle() {
  const sched_param none{};
  pthread_setschedparam(pthread_self(), SCHED_IDLE, &none);
}

/// At most `count` threads of the lowest priority that call `run`: fewer where the machine has no more to give. Not
/// oneTBB's, because a thread without privileges cannot leave SCHED_IDLE again.
std::vector<std::thread> start_idle_threads(std::size_t count, const std::function<void()>& run) {
  std::vector<std::thread> team;
  team.reserve(count);
  try {
    while (team.size() < count) {
      team.emplace_back([run] {
        run_only_when_idle();
        run();
      });
    }
  } catch (const std::system_error&) {  // those that started do the work
  }
  return team;
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
  if (!workers.yielding) {
    run_on_threads(static_cast<int>(threads), run);
    return whole;
  }
  std::mutex mutex;
  std::exception_ptr failure;  // the first; an exception that leaves a thread ends the process
  const auto guarded = [&] {
    try {
      run();
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
      whole = false;
    }
  };
  std::vector<std::thread> team = start_idle_threads(threads, guarded);
  if (team.empty()) guarded();  // the machine has no thread to give: the caller's own, which cannot yield
  for (std::thread& member : team) member.join();
  if (failure) std::rethrow_exception(failure);
  return whole;
}

}  // namespace pelage
