#include "tests/bench/cost.h"

#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>

#include "base/stopwatch.h"

namespace pelage::bench {

namespace {

double cpu_milliseconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) / 1e6;
}

}  // namespace

void Cost::lower_to(const Cost& other) { wall = std::min(wall, other.wall), cpu = std::min(cpu, other.cpu); }

Cost measure(const std::function<void()>& work) {
  const double cpu = cpu_milliseconds();
  const Stopwatch passed;
  work();
  return {passed.milliseconds(), cpu_milliseconds() - cpu};
}

std::vector<Cost> measure_alternating(const std::vector<std::function<void()>>& works, int repetitions) {
  std::vector<Cost> costs(works.size());
  for (const auto& work : works) work();
  for (int i = 0; i < repetitions; ++i) {
    for (std::size_t k = 0; k < works.size(); ++k) costs[k].lower_to(measure(works[k]));
  }
  return costs;
}

double resident_bytes() {
  std::ifstream pages("/proc/self/statm");
  double all = 0, resident = 0;
  pages >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

const char* text_argument(int count, char** arguments, const char* name) {
  for (int i = 1; i + 1 < count; i += 2) {
    if (arguments[i] == std::string(name)) return arguments[i + 1];
  }
  return nullptr;
}

int argument(int count, char** arguments, const char* name, int fallback) {
  const char* text = text_argument(count, arguments, name);
  return text ? std::atoi(text) : fallback;
}

}  // namespace pelage::bench
