// Lets one memory allocation fail on demand.
#pragma once

#include <cstddef>

namespace pelage {

/// While it exists, one allocation with operator new on its thread throws std::bad_alloc: the one with this number,
/// counted from 0. All others succeed. At most one per thread.
class FailingAllocation {
 public:
  explicit FailingAllocation(std::size_t number);
  ~FailingAllocation();
  FailingAllocation(const FailingAllocation&) = delete;
  FailingAllocation& operator=(const FailingAllocation&) = delete;

  /// Returns whether there were enough allocations for one to fail.
  bool failed() const;
};

}  // namespace pelage
