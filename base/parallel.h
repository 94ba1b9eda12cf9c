// Parallel loops whose results do not depend on the number of threads. Only parallel.cpp uses oneTBB.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace pelage {

/// Returns the number of cores that the calling thread may run on, at least 1. A farm or a container may pin it to
/// fewer than the machine has.
int core_count();

/// Returns the number of threads of a parallel loop if none is given: one for each core, at most 16.
int default_threads();

/// Calls `run` once on each of at most `threads` threads (at least 1), including the caller's, and waits for all. There
/// may be fewer if the system cannot start more, so `run` takes its work from a common counter. Each call has its own
/// arena, so the caller never executes another caller's work while it waits. The first exception is rethrown when all
/// threads have ended.
void run_on_threads(int threads, const std::function<void()>& run);

/// Calls `run` on the caller's thread and keeps libraries inside, such as Embree, from spreading work over oneTBB's
/// threads.
void run_on_this_thread(const std::function<void()>& run);

/// Calls work(0) ... work(count - 1) on at most `threads` threads, in no order. Each call writes its own results only.
/// After an exception, which is rethrown, no further call begins.
template <class Work>
void for_each_in_parallel(std::uint32_t count, const Work& work, int threads = default_threads()) {
  std::atomic<std::uint32_t> next = 0;
  std::atomic<bool> failed = false;
  run_on_threads(static_cast<int>(std::min<std::uint32_t>(static_cast<std::uint32_t>(threads), count)), [&] {
    struct StopOthers {
      std::atomic<bool>& failed;
      bool done = false;
      ~StopOthers() {
        if (!done) failed = true;
      }
    } stop_others{failed};
    for (std::uint32_t i = next++; i < count && !failed; i = next++) work(i);
    stop_others.done = true;
  });
}

/// The threads that share a job. Yielding threads run only while no other thread of the machine wants their core.
struct WorkThreads {
  int threads = 1;
  bool yielding = false;
};

/// Calls work(i) for i in [0, count), in any order and from several threads, until a call returns false. Returns
/// whether all were called and returned true. With one thread that does not yield, the caller's thread makes all calls.
bool for_each_until_false(const WorkThreads& workers, std::size_t count, const std::function<bool(std::size_t)>& work);

/// Calls both functions, on two threads if two can be had. They must write different results.
template <class First, class Second>
void run_both(const First& first, const Second& second) {
  for_each_in_parallel(2, [&](std::uint32_t k) { k == 0 ? first() : second(); });
}

/// Calls work(begin, end) for consecutive ranges of [0, count) on all cores, in no order; for one range if `count` is
/// small.
template <class Work>
void for_each_range_in_parallel(std::uint32_t count, const Work& work) {
  constexpr std::uint32_t run_length = 1 << 14;
  const std::uint32_t runs = (count + run_length - 1) / run_length;
  for_each_in_parallel(runs,
                       [&](std::uint32_t run) { work(run * run_length, std::min(count, (run + 1) * run_length)); });
}

}  // namespace pelage
