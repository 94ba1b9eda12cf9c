// Work on several threads whose result does not depend on their number. The only place that knows oneTBB.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace pelage {

/// Cores that the calling thread may run on, at least 1: fewer than the machine's where a farm or a container pins it.
int core_count();

/// Threads that a parallel loop uses where nobody asks for a number: one for each core, at most 16.
int default_threads();

/// Calls `run` once on each of at most `threads` threads (at least 1), the caller's among them, and waits for all.
/// There may be fewer where the machine has none to give, so `run` takes its work from a common counter. Each call has
/// an arena of its own, so the caller never carries out another caller's work while it waits. The first exception of a
/// run is thrown again when all have ended.
void run_on_threads(int threads, const std::function<void()>& run);

/// Calls `run` on the caller's thread, and keeps on it what a library inside would spread over oneTBB's threads.
void run_on_this_thread(const std::function<void()>& run);

/// Calls work(0) ... work(count - 1) on at most `threads` threads, in no order. Each call writes its own results only.
/// After an exception, which is thrown again, no further call begins.
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

/// Threads that work is spread over. Yielding ones run only where no other thread of the machine wants to.
struct WorkThreads {
  int threads = 1;
  bool yielding = false;
};

/// Calls work(i) for i in [0, count), in any order and from several threads, until a call returns false. Returns
/// whether all were called and returned true. With one thread that does not yield the caller's own calls them all.
bool for_each_until_false(const WorkThreads& workers, std::size_t count, const std::function<bool(std::size_t)>& work);

/// Calls both, on two threads where the machine has two to give. They write different results.
template <class First, class Second>
void run_both(const First& first, const Second& second) {
  for_each_in_parallel(2, [&](std::uint32_t k) { k == 0 ? first() : second(); });
}

/// Calls work(begin, end) for runs of [0, count) on all cores, in no order; one run where there is little to do.
template <class Work>
void for_each_run_in_parallel(std::uint32_t count, const Work& work) {
  constexpr std::uint32_t run_length = 1 << 14;
  const std::uint32_t runs = (count + run_length - 1) / run_length;
  for_each_in_parallel(runs,
                       [&](std::uint32_t run) { work(run * run_length, std::min(count, (run + 1) * run_length)); });
}

}  // namespace pelage
