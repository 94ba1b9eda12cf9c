#include "protocol/base/parallel.h"

#include <sched.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <exception>
#include <mutex>
#include <thread>

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace pelage {

int core_count() {
  cpu_set_t cores;
  if (sched_getaffinity(0, sizeof cores, &cores) == 0) return std::max(1, CPU_COUNT(&cores));
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));  // more cores than the set holds
}

int default_threads() { return std::min(core_count(), 16); }

namespace {

/// That one thread has done its part before another goes on. oneTBB sees to it; the thread sanitizer, which that
/// library is not built with, has to be told.
struct Order {
#if defined(__SANITIZE_THREAD__)
  void release() { __tsan_release(this); }
  void acquire() { __tsan_acquire(this); }
#else
  void release() {}
  void acquire() {}
#endif
};

}  // namespace

void run_on_threads(int threads, const std::function<void()>& run) {
  // On one core more threads would take turns, and oneTBB would complain on the error output.
  if (threads <= 1 || core_count() == 1) return run();
  std::mutex mutex;
  std::exception_ptr failure;
  Order begun, ended;
  begun.release();
  const auto guarded = [&] {
    begun.acquire();
    try {
      run();
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
    ended.release();
  };
  try {
    tbb::task_arena arena(threads);
    arena.execute([&] {
      tbb::parallel_for(
          0, threads, [&](int) { guarded(); }, tbb::simple_partitioner());
    });
  } catch (const std::exception&) {  // not of `run`: oneTBB could not start a thread, so the caller's own does the work
    guarded();
  }
  ended.acquire();
  if (failure) std::rethrow_exception(failure);
}

void run_on_this_thread(const std::function<void()>& run) {
  tbb::task_arena arena(1);
  arena.execute(run);
}

}  // namespace pelage
