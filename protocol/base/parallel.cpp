#include "protocol/base/parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <thread>

namespace pelage {

int default_threads() { return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 16u)); }

void run_on_threads(int threads, const std::function<void()>& run) {
  if (threads <= 1) return run();
  tbb::task_arena arena(threads);
  arena.execute([&] { tbb::parallel_for(0, threads, [&](int) { run(); }, tbb::simple_partitioner()); });
}

}  // namespace pelage
