// Costs on a loaded machine.
#pragma once

#include <functional>
#include <vector>

namespace pelage::bench {

struct Cost {
  double wall = 1e300, cpu = 1e300;  // milliseconds
  void lower_to(const Cost& other);
};

/// CPU is the time of all threads of the process, so that other processes count little.
Cost measure(const std::function<void()>& work);

/// The least cost of each, after one run that does not count; repetitions alternate between them, so that a machine
/// that gets slower makes all slower.
std::vector<Cost> measure_alternating(const std::vector<std::function<void()>>& works, int repetitions);

/// What the process has in memory now, bytes.
double resident_bytes();

/// What comes after `name` among the arguments, null for nothing.
const char* text_argument(int count, char** arguments, const char* name);

/// The number after `name` among the arguments, else `fallback`.
int argument(int count, char** arguments, const char* name, int fallback);

}  // namespace pelage::bench
