// Work on all cores whose result does not depend on their number.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

namespace pelage {

/// Calls work(0) ... work(count - 1) on all cores, in no order. Each call writes its own results only.
template <class Work>
void for_each_in_parallel(std::uint32_t count, const Work& work) {
  std::atomic<std::uint32_t> next = 0;
  const auto run = [&] {
    for (std::uint32_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::thread> others;
  const unsigned cores = std::min(std::thread::hardware_concurrency(), 16u);
  for (unsigned i = 1; i < cores && i < count; ++i) others.emplace_back(run);
  run();
  for (std::thread& other : others) other.join();
}

/// Calls work(begin, end) for runs of [0, count) on all cores, in no order; one run where there is little to do.
template <class Work>
void for_each_run_in_parallel(std::uint32_t count, const Work& work) {
  constexpr std::uint32_t run_length = 1 << 14;
  const std::uint32_t runs = (count + run_length - 1) / run_length;
  for_each_in_parallel(runs, [&](std::uint32_t run) {
    work(run * run_length, std::min(count, (run + 1) * run_length));
  });
}

}  // namespace pelage
