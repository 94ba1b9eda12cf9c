#include "base/parallel.h"

#include <pthread.h>
#include <sched.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace pelage {

int core_count() {
  cpu_set_t cores;
  if (sched_getaffinity(0, sizeof cores, &cores) == 0) return std::max(1, CPU_COUNT(&cores));
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));  // more cores than cpu_set_t holds
}

int default_threads() { return std::min(core_count(), 16); }

namespace {

/// Tells the thread sanitizer that one thread has done its part before another continues. oneTBB ensures that order
/// itself, but is not built with the sanitizer.
struct HappensBefore {
#if defined(__SANITIZE_THREAD__)
  void release() { __tsan_release(this); }
  void acquire() { __tsan_acquire(this); }
#else
  void release() {}
  void acquire() {}
#endif
};

/// Keeps the first exception of several threads. An exception that left its thread would end the process.
class FirstException {
 public:
  /// Calls `run`; keeps its exception and returns false if it throws.
  bool guard(const std::function<void()>& run) {
    try {
      run();
      return true;
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!first_) first_ = std::current_exception();
      return false;
    }
  }
  void rethrow() const {
    if (first_) std::rethrow_exception(first_);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr first_;
};

/// Gives the calling thread the lowest priority. If that fails, the thread keeps its priority and competes for the
/// cores.
void run_only_when_idle() {
  const sched_param none{};
  pthread_setschedparam(pthread_self(), SCHED_IDLE, &none);
}

/// Starts up to `count` threads of the lowest priority that call `run`; fewer if the system cannot start more. They are
/// not oneTBB's, because a thread without privileges cannot leave SCHED_IDLE again.
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
  } catch (const std::system_error&) {  // the threads that did start do the work
  }
  return team;
}

/// Calls `run`, which does not throw, on `threads` threads of the lowest priority, and waits for all of them.
void run_on_idle_threads(std::size_t threads, const std::function<void()>& run) {
  std::vector<std::thread> team = start_idle_threads(threads, run);
  if (team.empty()) run();  // no thread could be started: the caller's does the work, at its own priority
  for (std::thread& member : team) member.join();
}

}  // namespace

void run_on_threads(int threads, const std::function<void()>& run) {
  // On one core, more threads would only take turns, and oneTBB would write a warning to stderr.
  if (threads <= 1 || core_count() == 1) return run();
  FirstException failure;
  HappensBefore begun, ended;
  begun.release();
  const auto guarded = [&] {
    begun.acquire();
    failure.guard(run);
    ended.release();
  };
  try {
    tbb::task_arena arena(threads);
    arena.execute([&] {
      tbb::parallel_for(
          0, threads, [&](int) { guarded(); }, tbb::simple_partitioner());
    });
  } catch (const std::exception&) {  // not from `run`: oneTBB could not start a thread, so the caller's does the work
    guarded();
  }
  ended.acquire();
  failure.rethrow();
}

bool for_each_until_false(const WorkThreads& workers, std::size_t count, const std::function<bool(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> all{true};
  const auto run = [&] {
    for (std::size_t i = next++; i < count && all; i = next++)
      if (!work(i)) all = false;
  };
  const std::size_t threads = std::min<std::size_t>(static_cast<std::size_t>(std::max(1, workers.threads)), count);
  if (!workers.yielding) {
    run_on_threads(static_cast<int>(threads), run);
    return all;
  }
  FirstException failure;
  run_on_idle_threads(threads, [&] {
    if (!failure.guard(run)) all = false;
  });
  failure.rethrow();
  return all;
}

void run_on_this_thread(const std::function<void()>& run) {
  tbb::task_arena arena(1);
  arena.execute(run);
}

}  // namespace pelage
