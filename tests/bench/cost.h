// Measures work in wall-clock and CPU time, and reads the command lines of benchmarks.
#pragma once

#include <functional>
#include <vector>

namespace pelage::bench {

struct Cost {
  double wall = 1e300, cpu = 1e300;  // milliseconds
  void lower_to(const Cost& other);
};

/// Runs `work` once. CPU time is that of all threads of this process, so other processes affect it little.
Cost measure(const std::function<void()>& work);

/// Returns the minimum cost of each, after one warm-up run that does not count. Repetitions alternate between the
/// works, so a machine that slows down slows all of them.
std::vector<Cost> measure_alternating(const std::vector<std::function<void()>>& works, int repetitions);

/// Resident memory of this process, in bytes.
double resident_bytes();

/// Returns the argument after `name`, or null if there is none.
const char* text_argument(int count, char** arguments, const char* name);

/// Returns the number after `name`, or `fallback` if there is none.
int argument(int count, char** arguments, const char* name, int fallback);

}  // namespace pelage::bench
