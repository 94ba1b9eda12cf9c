#include "protocol/base/parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <exception>
#include <mutex>
#include <thread>

namespace pelage {

int default_threads() { return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 16u)); }

void run_on_threads(int threads, const std::function<void()>& run) {
  if (threads <= 1) return run();
  std::mutex mutex;
  std::exception_ptr failure;
  const auto guarded = [&] {
    try {
      run();
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
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
  if (failure) std::rethrow_exception(failure);
}

void run_on_this_thread(const std::function<void()>& run) {
  tbb::task_arena arena(1);
  arena.execute(run);
}

}  // namespace pelage
